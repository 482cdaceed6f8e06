/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { RunState } from './RunState';
import {
    RunStateFromJSON,
    RunStateFromJSONTyped,
    RunStateToJSON,
    RunStateToJSONTyped,
} from './RunState';
import type { GroupScore } from './GroupScore';
import {
    GroupScoreFromJSON,
    GroupScoreFromJSONTyped,
    GroupScoreToJSON,
    GroupScoreToJSONTyped,
} from './GroupScore';
import type { SelectionView } from './SelectionView';
import {
    SelectionViewFromJSON,
    SelectionViewFromJSONTyped,
    SelectionViewToJSON,
    SelectionViewToJSONTyped,
} from './SelectionView';
import type { OutcomeCounts } from './OutcomeCounts';
import {
    OutcomeCountsFromJSON,
    OutcomeCountsFromJSONTyped,
    OutcomeCountsToJSON,
    OutcomeCountsToJSONTyped,
} from './OutcomeCounts';
import type { Interval } from './Interval';
import {
    IntervalFromJSON,
    IntervalFromJSONTyped,
    IntervalToJSON,
    IntervalToJSONTyped,
} from './Interval';

/**
 * See scoring.md for every number here.
 * @export
 * @interface Score
 */
export interface Score {
    [key: string]: any | any;
    /**
     *
     */
    run_id: string;
    /**
     *
     */
    benchmark_id: string;
    /**
     * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
     */
    manifest_sha256: string;
    /**
     *
     */
    select?: SelectionView;
    /**
     *
     */
    state: RunState;
    /**
     *
     */
    complete: boolean;
    /**
     * Null until complete.
     */
    score: number | null;
    /**
     *
     */
    score_low: number;
    /**
     *
     */
    score_high: number;
    /**
     *
     */
    counts: OutcomeCounts;
    /**
     *
     */
    success_rate: number | null;
    /**
     *
     */
    success_interval: Interval;
    /**
     * Mean over the scored episodes.
     */
    mean: number | null;
    /**
     *
     */
    mean_interval: Interval;
    /**
     *
     */
    by_task: { [key: string]: GroupScore; };
    /**
     *
     */
    by_split: { [key: string]: GroupScore; };
}



/**
 * Check if a given object implements the Score interface.
 */
export function instanceOfScore(value: object): value is Score {
    if (!('run_id' in value) || value['run_id'] === undefined) return false;
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('state' in value) || value['state'] === undefined) return false;
    if (!('complete' in value) || value['complete'] === undefined) return false;
    if (!('score' in value) || value['score'] === undefined) return false;
    if (!('score_low' in value) || value['score_low'] === undefined) return false;
    if (!('score_high' in value) || value['score_high'] === undefined) return false;
    if (!('counts' in value) || value['counts'] === undefined) return false;
    if (!('success_rate' in value) || value['success_rate'] === undefined) return false;
    if (!('success_interval' in value) || value['success_interval'] === undefined) return false;
    if (!('mean' in value) || value['mean'] === undefined) return false;
    if (!('mean_interval' in value) || value['mean_interval'] === undefined) return false;
    if (!('by_task' in value) || value['by_task'] === undefined) return false;
    if (!('by_split' in value) || value['by_split'] === undefined) return false;
    return true;
}

export function ScoreFromJSON(json: any): Score {
    return ScoreFromJSONTyped(json, false);
}

export function ScoreFromJSONTyped(json: any, ignoreDiscriminator: boolean): Score {
    if (json == null) {
        return json;
    }
    checkMembers('Score', json);
    return {

            ...json,
        'run_id': json['run_id'],
        'benchmark_id': json['benchmark_id'],
        'manifest_sha256': json['manifest_sha256'],
        'select': json['select'] == null ? undefined : SelectionViewFromJSON(json['select']),
        'state': RunStateFromJSON(json['state']),
        'complete': json['complete'],
        'score': json['score'],
        'score_low': json['score_low'],
        'score_high': json['score_high'],
        'counts': OutcomeCountsFromJSON(json['counts']),
        'success_rate': json['success_rate'],
        'success_interval': IntervalFromJSON(json['success_interval']),
        'mean': json['mean'],
        'mean_interval': IntervalFromJSON(json['mean_interval']),
        'by_task': (mapValues(json['by_task'], GroupScoreFromJSON)),
        'by_split': (mapValues(json['by_split'], GroupScoreFromJSON)),
    };
}

export function ScoreToJSON(json: any): Score {
    return ScoreToJSONTyped(json, false);
}

export function ScoreToJSONTyped(value?: Score | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'run_id': value['run_id'],
        'benchmark_id': value['benchmark_id'],
        'manifest_sha256': value['manifest_sha256'],
        'select': SelectionViewToJSON(value['select']),
        'state': RunStateToJSON(value['state']),
        'complete': value['complete'],
        'score': value['score'],
        'score_low': value['score_low'],
        'score_high': value['score_high'],
        'counts': OutcomeCountsToJSON(value['counts']),
        'success_rate': value['success_rate'],
        'success_interval': IntervalToJSON(value['success_interval']),
        'mean': value['mean'],
        'mean_interval': IntervalToJSON(value['mean_interval']),
        'by_task': (mapValues(value['by_task'], GroupScoreToJSON)),
        'by_split': (mapValues(value['by_split'], GroupScoreToJSON)),
    };
}
