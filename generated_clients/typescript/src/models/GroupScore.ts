/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { OutcomeCounts } from './OutcomeCounts';
import {
    OutcomeCountsFromJSON,
    OutcomeCountsFromJSONTyped,
    OutcomeCountsToJSON,
    OutcomeCountsToJSONTyped,
} from './OutcomeCounts';

/**
 *
 * @export
 * @interface GroupScore
 */
export interface GroupScore {
    [key: string]: any | any;
    /**
     *
     */
    counts: OutcomeCounts;
    /**
     *
     */
    mean: number | null;
    /**
     *
     */
    success_rate: number | null;
}

/**
 * Check if a given object implements the GroupScore interface.
 */
export function instanceOfGroupScore(value: object): value is GroupScore {
    if (!('counts' in value) || value['counts'] === undefined) return false;
    if (!('mean' in value) || value['mean'] === undefined) return false;
    if (!('success_rate' in value) || value['success_rate'] === undefined) return false;
    return true;
}

export function GroupScoreFromJSON(json: any): GroupScore {
    return GroupScoreFromJSONTyped(json, false);
}

export function GroupScoreFromJSONTyped(json: any, ignoreDiscriminator: boolean): GroupScore {
    if (json == null) {
        return json;
    }
    checkMembers('GroupScore', json);
    return {

            ...json,
        'counts': OutcomeCountsFromJSON(json['counts']),
        'mean': json['mean'],
        'success_rate': json['success_rate'],
    };
}

export function GroupScoreToJSON(json: any): GroupScore {
    return GroupScoreToJSONTyped(json, false);
}

export function GroupScoreToJSONTyped(value?: GroupScore | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'counts': OutcomeCountsToJSON(value['counts']),
        'mean': value['mean'],
        'success_rate': value['success_rate'],
    };
}
