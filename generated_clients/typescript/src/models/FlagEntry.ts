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
 * @interface FlagEntry
 */
export interface FlagEntry {
    /**
     * False takes the flag back.
     */
    flagged: boolean;
    /**
     * Shown with the entry.
     */
    reason: string;
}

/**
 * Check if a given object implements the FlagEntry interface.
 */
export function instanceOfFlagEntry(value: object): value is FlagEntry {
    if (!('flagged' in value) || value['flagged'] === undefined) return false;
    if (!('reason' in value) || value['reason'] === undefined) return false;
    return true;
}

export function FlagEntryFromJSON(json: any): FlagEntry {
    return FlagEntryFromJSONTyped(json, false);
}

export function FlagEntryFromJSONTyped(json: any, ignoreDiscriminator: boolean): FlagEntry {
    if (json == null) {
        return json;
    }
    checkMembers('FlagEntry', json);
    return {

        'flagged': json['flagged'],
        'reason': json['reason'],
    };
}

export function FlagEntryToJSON(json: any): FlagEntry {
    return FlagEntryToJSONTyped(json, false);
}

export function FlagEntryToJSONTyped(value?: FlagEntry | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'flagged': value['flagged'],
        'reason': value['reason'],
    };
}
