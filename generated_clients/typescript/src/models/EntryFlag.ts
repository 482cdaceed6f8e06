/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues, parseDate, parseDateTime, serializeDate, serializeDateTime } from '../runtime';
import { checkMembers } from '../shapes';
/**
 *
 * @export
 * @interface EntryFlag
 */
export interface EntryFlag {
    [key: string]: any | any;
    /**
     *
     */
    reason: string;
    /**
     *
     */
    flagged_at: Date;
}

/**
 * Check if a given object implements the EntryFlag interface.
 */
export function instanceOfEntryFlag(value: object): value is EntryFlag {
    if (!('reason' in value) || value['reason'] === undefined) return false;
    if (!('flagged_at' in value) || value['flagged_at'] === undefined) return false;
    return true;
}

export function EntryFlagFromJSON(json: any): EntryFlag {
    return EntryFlagFromJSONTyped(json, false);
}

export function EntryFlagFromJSONTyped(json: any, ignoreDiscriminator: boolean): EntryFlag {
    if (json == null) {
        return json;
    }
    checkMembers('EntryFlag', json);
    return {

            ...json,
        'reason': json['reason'],
        'flagged_at': (json['flagged_at'] == null ? json['flagged_at'] : parseDateTime(json['flagged_at'])),
    };
}

export function EntryFlagToJSON(json: any): EntryFlag {
    return EntryFlagToJSONTyped(json, false);
}

export function EntryFlagToJSONTyped(value?: EntryFlag | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'reason': value['reason'],
        'flagged_at': value['flagged_at'] == null ? value['flagged_at'] : serializeDateTime(value['flagged_at']),
    };
}
