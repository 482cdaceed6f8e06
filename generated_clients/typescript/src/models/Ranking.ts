/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { RankedEntry } from './RankedEntry';
import {
    RankedEntryFromJSON,
    RankedEntryFromJSONTyped,
    RankedEntryToJSON,
    RankedEntryToJSONTyped,
} from './RankedEntry';

/**
 * See board.md for every number here.
 * @export
 * @interface Ranking
 */
export interface Ranking {
    [key: string]: any | any;
    /**
     *
     */
    benchmark_id: string;
    /**
     * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
     */
    manifest_sha256: string;
    /**
     * How many episodes each entry has; null where the manifest has no entry.
     */
    episodes_total: number | null;
    /**
     * How many entries have a rank.
     */
    ranked: number;
    /**
     * How many pairs of them were tested.
     */
    comparisons: number;
    /**
     * How likely it is at most that any two equally good policies are distinguished; 0.05.
     */
    alpha: number;
    /**
     * Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes.
     */
    differing_min: number | null;
    /**
     * Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes.
     */
    differing_enough: number | null;
    /**
     *
     */
    rows: Array<RankedEntry>;
    /**
     *
     */
    next_cursor: string | null;
}

/**
 * Check if a given object implements the Ranking interface.
 */
export function instanceOfRanking(value: object): value is Ranking {
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('episodes_total' in value) || value['episodes_total'] === undefined) return false;
    if (!('ranked' in value) || value['ranked'] === undefined) return false;
    if (!('comparisons' in value) || value['comparisons'] === undefined) return false;
    if (!('alpha' in value) || value['alpha'] === undefined) return false;
    if (!('differing_min' in value) || value['differing_min'] === undefined) return false;
    if (!('differing_enough' in value) || value['differing_enough'] === undefined) return false;
    if (!('rows' in value) || value['rows'] === undefined) return false;
    if (!('next_cursor' in value) || value['next_cursor'] === undefined) return false;
    return true;
}

export function RankingFromJSON(json: any): Ranking {
    return RankingFromJSONTyped(json, false);
}

export function RankingFromJSONTyped(json: any, ignoreDiscriminator: boolean): Ranking {
    if (json == null) {
        return json;
    }
    checkMembers('Ranking', json);
    return {

            ...json,
        'benchmark_id': json['benchmark_id'],
        'manifest_sha256': json['manifest_sha256'],
        'episodes_total': json['episodes_total'],
        'ranked': json['ranked'],
        'comparisons': json['comparisons'],
        'alpha': json['alpha'],
        'differing_min': json['differing_min'],
        'differing_enough': json['differing_enough'],
        'rows': ((json['rows'] as Array<any>).map(RankedEntryFromJSON)),
        'next_cursor': json['next_cursor'],
    };
}

export function RankingToJSON(json: any): Ranking {
    return RankingToJSONTyped(json, false);
}

export function RankingToJSONTyped(value?: Ranking | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'benchmark_id': value['benchmark_id'],
        'manifest_sha256': value['manifest_sha256'],
        'episodes_total': value['episodes_total'],
        'ranked': value['ranked'],
        'comparisons': value['comparisons'],
        'alpha': value['alpha'],
        'differing_min': value['differing_min'],
        'differing_enough': value['differing_enough'],
        'rows': ((value['rows'] as Array<any>).map(RankedEntryToJSON)),
        'next_cursor': value['next_cursor'],
    };
}
