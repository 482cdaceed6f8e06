/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * 95 % interval.
 * @export
 * @interface Interval
 */
export interface Interval {
    [key: string]: any | any;
    /**
     *
     */
    low: number;
    /**
     *
     */
    high: number;
}

/**
 * Check if a given object implements the Interval interface.
 */
export function instanceOfInterval(value: object): value is Interval {
    if (!('low' in value) || value['low'] === undefined) return false;
    if (!('high' in value) || value['high'] === undefined) return false;
    return true;
}

export function IntervalFromJSON(json: any): Interval {
    return IntervalFromJSONTyped(json, false);
}

export function IntervalFromJSONTyped(json: any, ignoreDiscriminator: boolean): Interval {
    if (json == null) {
        return json;
    }
    checkMembers('Interval', json);
    return {

            ...json,
        'low': json['low'],
        'high': json['high'],
    };
}

export function IntervalToJSON(json: any): Interval {
    return IntervalToJSONTyped(json, false);
}

export function IntervalToJSONTyped(value?: Interval | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'low': value['low'],
        'high': value['high'],
    };
}
