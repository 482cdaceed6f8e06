/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { RankInterval } from './RankInterval';
import {
    RankIntervalFromJSON,
    RankIntervalFromJSONTyped,
    RankIntervalToJSON,
    RankIntervalToJSONTyped,
} from './RankInterval';
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
 * @interface RankedEntry
 */
export interface RankedEntry {
    [key: string]: any | any;
    /**
     *
     */
    entry: BoardEntry;
    /**
     *
     */
    rank?: RankInterval;
    /**
     * How many entries are significantly better; 0 without a rank.
     */
    better: number;
    /**
     * How many entries are significantly worse; 0 without a rank.
     */
    worse: number;
    /**
     * Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank.
     */
    letters: Array<string>;
}

/**
 * Check if a given object implements the RankedEntry interface.
 */
export function instanceOfRankedEntry(value: object): value is RankedEntry {
    if (!('entry' in value) || value['entry'] === undefined) return false;
    if (!('better' in value) || value['better'] === undefined) return false;
    if (!('worse' in value) || value['worse'] === undefined) return false;
    if (!('letters' in value) || value['letters'] === undefined) return false;
    return true;
}

export function RankedEntryFromJSON(json: any): RankedEntry {
    return RankedEntryFromJSONTyped(json, false);
}

export function RankedEntryFromJSONTyped(json: any, ignoreDiscriminator: boolean): RankedEntry {
    if (json == null) {
        return json;
    }
    checkMembers('RankedEntry', json);
    return {

            ...json,
        'entry': BoardEntryFromJSON(json['entry']),
        'rank': json['rank'] == null ? undefined : RankIntervalFromJSON(json['rank']),
        'better': json['better'],
        'worse': json['worse'],
        'letters': json['letters'],
    };
}

export function RankedEntryToJSON(json: any): RankedEntry {
    return RankedEntryToJSONTyped(json, false);
}

export function RankedEntryToJSONTyped(value?: RankedEntry | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'entry': BoardEntryToJSON(value['entry']),
        'rank': RankIntervalToJSON(value['rank']),
        'better': value['better'],
        'worse': value['worse'],
        'letters': value['letters'],
    };
}
