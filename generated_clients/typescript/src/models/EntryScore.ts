/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { GroupScore } from './GroupScore';
import {
    GroupScoreFromJSON,
    GroupScoreFromJSONTyped,
    GroupScoreToJSON,
    GroupScoreToJSONTyped,
} from './GroupScore';
import type { OutcomeCounts } from './OutcomeCounts';
import {
    OutcomeCountsFromJSON,
    OutcomeCountsFromJSONTyped,
    OutcomeCountsToJSON,
    OutcomeCountsToJSONTyped,
} from './OutcomeCounts';
import type { Interval } from './Interval';
import {
    IntervalFromJSON,
    IntervalFromJSONTyped,
    IntervalToJSON,
    IntervalToJSONTyped,
} from './Interval';

/**
 * Of the `get_score` of the run.
 * @export
 * @interface EntryScore
 */
export interface EntryScore {
    [key: string]: any | any;
    /**
     *
     */
    score: number;
    /**
     *
     */
    success_rate: number;
    /**
     *
     */
    success_interval: Interval;
    /**
     *
     */
    mean_interval: Interval;
    /**
     *
     */
    counts: OutcomeCounts;
    /**
     * Absent where the server does not show it, such as for many tasks.
     */
    by_task?: { [key: string]: GroupScore; };
    /**
     * Absent where the server does not show it, such as for many splits.
     */
    by_split?: { [key: string]: GroupScore; };
}

/**
 * Check if a given object implements the EntryScore interface.
 */
export function instanceOfEntryScore(value: object): value is EntryScore {
    if (!('score' in value) || value['score'] === undefined) return false;
    if (!('success_rate' in value) || value['success_rate'] === undefined) return false;
    if (!('success_interval' in value) || value['success_interval'] === undefined) return false;
    if (!('mean_interval' in value) || value['mean_interval'] === undefined) return false;
    if (!('counts' in value) || value['counts'] === undefined) return false;
    return true;
}

export function EntryScoreFromJSON(json: any): EntryScore {
    return EntryScoreFromJSONTyped(json, false);
}

export function EntryScoreFromJSONTyped(json: any, ignoreDiscriminator: boolean): EntryScore {
    if (json == null) {
        return json;
    }
    checkMembers('EntryScore', json);
    return {

            ...json,
        'score': json['score'],
        'success_rate': json['success_rate'],
        'success_interval': IntervalFromJSON(json['success_interval']),
        'mean_interval': IntervalFromJSON(json['mean_interval']),
        'counts': OutcomeCountsFromJSON(json['counts']),
        'by_task': json['by_task'] == null ? undefined : (mapValues(json['by_task'], GroupScoreFromJSON)),
        'by_split': json['by_split'] == null ? undefined : (mapValues(json['by_split'], GroupScoreFromJSON)),
    };
}

export function EntryScoreToJSON(json: any): EntryScore {
    return EntryScoreToJSONTyped(json, false);
}

export function EntryScoreToJSONTyped(value?: EntryScore | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'score': value['score'],
        'success_rate': value['success_rate'],
        'success_interval': IntervalToJSON(value['success_interval']),
        'mean_interval': IntervalToJSON(value['mean_interval']),
        'counts': OutcomeCountsToJSON(value['counts']),
        'by_task': value['by_task'] == null ? undefined : (mapValues(value['by_task'], GroupScoreToJSON)),
        'by_split': value['by_split'] == null ? undefined : (mapValues(value['by_split'], GroupScoreToJSON)),
    };
}
