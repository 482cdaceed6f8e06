/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 *
 * @export
 * @interface OutcomeCounts
 */
export interface OutcomeCounts {
    [key: string]: any | any;
    /**
     *
     */
    total: number;
    /**
     *
     */
    success: number;
    /**
     *
     */
    failure: number;
    /**
     *
     */
    abandoned: number;
    /**
     *
     */
    unscored: number;
}

/**
 * Check if a given object implements the OutcomeCounts interface.
 */
export function instanceOfOutcomeCounts(value: object): value is OutcomeCounts {
    if (!('total' in value) || value['total'] === undefined) return false;
    if (!('success' in value) || value['success'] === undefined) return false;
    if (!('failure' in value) || value['failure'] === undefined) return false;
    if (!('abandoned' in value) || value['abandoned'] === undefined) return false;
    if (!('unscored' in value) || value['unscored'] === undefined) return false;
    return true;
}

export function OutcomeCountsFromJSON(json: any): OutcomeCounts {
    return OutcomeCountsFromJSONTyped(json, false);
}

export function OutcomeCountsFromJSONTyped(json: any, ignoreDiscriminator: boolean): OutcomeCounts {
    if (json == null) {
        return json;
    }
    checkMembers('OutcomeCounts', json);
    return {

            ...json,
        'total': json['total'],
        'success': json['success'],
        'failure': json['failure'],
        'abandoned': json['abandoned'],
        'unscored': json['unscored'],
    };
}

export function OutcomeCountsToJSON(json: any): OutcomeCounts {
    return OutcomeCountsToJSONTyped(json, false);
}

export function OutcomeCountsToJSONTyped(value?: OutcomeCounts | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'total': value['total'],
        'success': value['success'],
        'failure': value['failure'],
        'abandoned': value['abandoned'],
        'unscored': value['unscored'],
    };
}
