/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Benchmark } from './Benchmark';
import {
    BenchmarkFromJSON,
    BenchmarkFromJSONTyped,
    BenchmarkToJSON,
    BenchmarkToJSONTyped,
} from './Benchmark';
import type { EpisodeView } from './EpisodeView';
import {
    EpisodeViewFromJSON,
    EpisodeViewFromJSONTyped,
    EpisodeViewToJSON,
    EpisodeViewToJSONTyped,
} from './EpisodeView';

/**
 * An attempt begins; whatever the policy remembers of this session is over.
 * @export
 * @interface ResetPolicy
 */
export interface ResetPolicy {
    [key: string]: any | any;
    /**
     *
     */
    session_id: string;
    /**
     *
     */
    run_id?: string;
    /**
     *
     */
    benchmark: Benchmark;
    /**
     *
     */
    episode: EpisodeView;
}

/**
 * Check if a given object implements the ResetPolicy interface.
 */
export function instanceOfResetPolicy(value: object): value is ResetPolicy {
    if (!('session_id' in value) || value['session_id'] === undefined) return false;
    if (!('benchmark' in value) || value['benchmark'] === undefined) return false;
    if (!('episode' in value) || value['episode'] === undefined) return false;
    return true;
}

export function ResetPolicyFromJSON(json: any): ResetPolicy {
    return ResetPolicyFromJSONTyped(json, false);
}

export function ResetPolicyFromJSONTyped(json: any, ignoreDiscriminator: boolean): ResetPolicy {
    if (json == null) {
        return json;
    }
    checkMembers('ResetPolicy', json);
    return {

            ...json,
        'session_id': json['session_id'],
        'run_id': json['run_id'] == null ? undefined : json['run_id'],
        'benchmark': BenchmarkFromJSON(json['benchmark']),
        'episode': EpisodeViewFromJSON(json['episode']),
    };
}

export function ResetPolicyToJSON(json: any): ResetPolicy {
    return ResetPolicyToJSONTyped(json, false);
}

export function ResetPolicyToJSONTyped(value?: ResetPolicy | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'session_id': value['session_id'],
        'run_id': value['run_id'],
        'benchmark': BenchmarkToJSON(value['benchmark']),
        'episode': EpisodeViewToJSON(value['episode']),
    };
}
