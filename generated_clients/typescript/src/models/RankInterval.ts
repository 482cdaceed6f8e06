/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The ranks that an entry may have; absent for an entry that is flagged.
 * @export
 * @interface RankInterval
 */
export interface RankInterval {
    [key: string]: any | any;
    /**
     * The best one.
     */
    low: number;
    /**
     * The worst one.
     */
    high: number;
}

/**
 * Check if a given object implements the RankInterval interface.
 */
export function instanceOfRankInterval(value: object): value is RankInterval {
    if (!('low' in value) || value['low'] === undefined) return false;
    if (!('high' in value) || value['high'] === undefined) return false;
    return true;
}

export function RankIntervalFromJSON(json: any): RankInterval {
    return RankIntervalFromJSONTyped(json, false);
}

export function RankIntervalFromJSONTyped(json: any, ignoreDiscriminator: boolean): RankInterval {
    if (json == null) {
        return json;
    }
    checkMembers('RankInterval', json);
    return {

            ...json,
        'low': json['low'],
        'high': json['high'],
    };
}

export function RankIntervalToJSON(json: any): RankInterval {
    return RankIntervalToJSONTyped(json, false);
}

export function RankIntervalToJSONTyped(value?: RankInterval | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'low': value['low'],
        'high': value['high'],
    };
}
