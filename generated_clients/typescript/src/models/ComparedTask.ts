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
 * @interface ComparedTask
 */
export interface ComparedTask {
    [key: string]: any | any;
    /**
     *
     */
    paired: number;
    /**
     *
     */
    baseline_mean: number | null;
    /**
     *
     */
    mean: number | null;
    /**
     *
     */
    difference: number | null;
}

/**
 * Check if a given object implements the ComparedTask interface.
 */
export function instanceOfComparedTask(value: object): value is ComparedTask {
    if (!('paired' in value) || value['paired'] === undefined) return false;
    if (!('baseline_mean' in value) || value['baseline_mean'] === undefined) return false;
    if (!('mean' in value) || value['mean'] === undefined) return false;
    if (!('difference' in value) || value['difference'] === undefined) return false;
    return true;
}

export function ComparedTaskFromJSON(json: any): ComparedTask {
    return ComparedTaskFromJSONTyped(json, false);
}

export function ComparedTaskFromJSONTyped(json: any, ignoreDiscriminator: boolean): ComparedTask {
    if (json == null) {
        return json;
    }
    checkMembers('ComparedTask', json);
    return {

            ...json,
        'paired': json['paired'],
        'baseline_mean': json['baseline_mean'],
        'mean': json['mean'],
        'difference': json['difference'],
    };
}

export function ComparedTaskToJSON(json: any): ComparedTask {
    return ComparedTaskToJSONTyped(json, false);
}

export function ComparedTaskToJSONTyped(value?: ComparedTask | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'paired': value['paired'],
        'baseline_mean': value['baseline_mean'],
        'mean': value['mean'],
        'difference': value['difference'],
    };
}
