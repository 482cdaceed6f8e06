/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { ReplayDivergence } from './ReplayDivergence';
import {
    ReplayDivergenceFromJSON,
    ReplayDivergenceFromJSONTyped,
    ReplayDivergenceToJSON,
    ReplayDivergenceToJSONTyped,
} from './ReplayDivergence';

/**
 * As in a verdict (record.md); absent before the end of the replay, and where there is none.
 * @export
 * @interface RecordReplay
 */
export interface RecordReplay {
    [key: string]: any | any;
    /**
     * `exact`, `outcome` or `diverged`.
     */
    result: string;
    /**
     *
     */
    episodes: number;
    /**
     *
     */
    exact: number;
    /**
     *
     */
    outcome: number;
    /**
     *
     */
    diverged: number;
    /**
     *
     */
    first_divergence?: ReplayDivergence;
}

/**
 * Check if a given object implements the RecordReplay interface.
 */
export function instanceOfRecordReplay(value: object): value is RecordReplay {
    if (!('result' in value) || value['result'] === undefined) return false;
    if (!('episodes' in value) || value['episodes'] === undefined) return false;
    if (!('exact' in value) || value['exact'] === undefined) return false;
    if (!('outcome' in value) || value['outcome'] === undefined) return false;
    if (!('diverged' in value) || value['diverged'] === undefined) return false;
    return true;
}

export function RecordReplayFromJSON(json: any): RecordReplay {
    return RecordReplayFromJSONTyped(json, false);
}

export function RecordReplayFromJSONTyped(json: any, ignoreDiscriminator: boolean): RecordReplay {
    if (json == null) {
        return json;
    }
    checkMembers('RecordReplay', json);
    return {

            ...json,
        'result': json['result'],
        'episodes': json['episodes'],
        'exact': json['exact'],
        'outcome': json['outcome'],
        'diverged': json['diverged'],
        'first_divergence': json['first_divergence'] == null ? undefined : ReplayDivergenceFromJSON(json['first_divergence']),
    };
}

export function RecordReplayToJSON(json: any): RecordReplay {
    return RecordReplayToJSONTyped(json, false);
}

export function RecordReplayToJSONTyped(value?: RecordReplay | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'result': value['result'],
        'episodes': value['episodes'],
        'exact': value['exact'],
        'outcome': value['outcome'],
        'diverged': value['diverged'],
        'first_divergence': ReplayDivergenceToJSON(value['first_divergence']),
    };
}
