/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Run } from './Run';
import {
    RunFromJSON,
    RunFromJSONTyped,
    RunToJSON,
    RunToJSONTyped,
} from './Run';

/**
 *
 * @export
 * @interface RunList
 */
export interface RunList {
    [key: string]: any | any;
    /**
     *
     */
    runs: Array<Run>;
    /**
     *
     */
    next_cursor: string | null;
}

/**
 * Check if a given object implements the RunList interface.
 */
export function instanceOfRunList(value: object): value is RunList {
    if (!('runs' in value) || value['runs'] === undefined) return false;
    if (!('next_cursor' in value) || value['next_cursor'] === undefined) return false;
    return true;
}

export function RunListFromJSON(json: any): RunList {
    return RunListFromJSONTyped(json, false);
}

export function RunListFromJSONTyped(json: any, ignoreDiscriminator: boolean): RunList {
    if (json == null) {
        return json;
    }
    checkMembers('RunList', json);
    return {

            ...json,
        'runs': ((json['runs'] as Array<any>).map(RunFromJSON)),
        'next_cursor': json['next_cursor'],
    };
}

export function RunListToJSON(json: any): RunList {
    return RunListToJSONTyped(json, false);
}

export function RunListToJSONTyped(value?: RunList | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'runs': ((value['runs'] as Array<any>).map(RunToJSON)),
        'next_cursor': value['next_cursor'],
    };
}
