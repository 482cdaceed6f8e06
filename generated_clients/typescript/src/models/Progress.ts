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
 * @interface Progress
 */
export interface Progress {
    [key: string]: any | any;
    /**
     *
     */
    episodes_total: number;
    /**
     * Abandoned ones included.
     */
    episodes_scored: number;
    /**
     *
     */
    episodes_in_progress: number;
    /**
     *
     */
    episodes_pending: number;
}

/**
 * Check if a given object implements the Progress interface.
 */
export function instanceOfProgress(value: object): value is Progress {
    if (!('episodes_total' in value) || value['episodes_total'] === undefined) return false;
    if (!('episodes_scored' in value) || value['episodes_scored'] === undefined) return false;
    if (!('episodes_in_progress' in value) || value['episodes_in_progress'] === undefined) return false;
    if (!('episodes_pending' in value) || value['episodes_pending'] === undefined) return false;
    return true;
}

export function ProgressFromJSON(json: any): Progress {
    return ProgressFromJSONTyped(json, false);
}

export function ProgressFromJSONTyped(json: any, ignoreDiscriminator: boolean): Progress {
    if (json == null) {
        return json;
    }
    checkMembers('Progress', json);
    return {

            ...json,
        'episodes_total': json['episodes_total'],
        'episodes_scored': json['episodes_scored'],
        'episodes_in_progress': json['episodes_in_progress'],
        'episodes_pending': json['episodes_pending'],
    };
}

export function ProgressToJSON(json: any): Progress {
    return ProgressToJSONTyped(json, false);
}

export function ProgressToJSONTyped(value?: Progress | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'episodes_total': value['episodes_total'],
        'episodes_scored': value['episodes_scored'],
        'episodes_in_progress': value['episodes_in_progress'],
        'episodes_pending': value['episodes_pending'],
    };
}
