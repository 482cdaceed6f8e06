/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { BoardEntry } from './BoardEntry';
import {
    BoardEntryFromJSON,
    BoardEntryFromJSONTyped,
    BoardEntryToJSON,
    BoardEntryToJSONTyped,
} from './BoardEntry';

/**
 *
 * @export
 * @interface BoardEntryList
 */
export interface BoardEntryList {
    [key: string]: any | any;
    /**
     *
     */
    entries: Array<BoardEntry>;
    /**
     *
     */
    next_cursor: string | null;
}

/**
 * Check if a given object implements the BoardEntryList interface.
 */
export function instanceOfBoardEntryList(value: object): value is BoardEntryList {
    if (!('entries' in value) || value['entries'] === undefined) return false;
    if (!('next_cursor' in value) || value['next_cursor'] === undefined) return false;
    return true;
}

export function BoardEntryListFromJSON(json: any): BoardEntryList {
    return BoardEntryListFromJSONTyped(json, false);
}

export function BoardEntryListFromJSONTyped(json: any, ignoreDiscriminator: boolean): BoardEntryList {
    if (json == null) {
        return json;
    }
    checkMembers('BoardEntryList', json);
    return {

            ...json,
        'entries': ((json['entries'] as Array<any>).map(BoardEntryFromJSON)),
        'next_cursor': json['next_cursor'],
    };
}

export function BoardEntryListToJSON(json: any): BoardEntryList {
    return BoardEntryListToJSONTyped(json, false);
}

export function BoardEntryListToJSONTyped(value?: BoardEntryList | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'entries': ((value['entries'] as Array<any>).map(BoardEntryToJSON)),
        'next_cursor': value['next_cursor'],
    };
}
