/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { ComparedTask } from './ComparedTask';
import {
    ComparedTaskFromJSON,
    ComparedTaskFromJSONTyped,
    ComparedTaskToJSON,
    ComparedTaskToJSONTyped,
} from './ComparedTask';

/**
 * One run beside the baseline. A pair is an episode that both have scored.
 * @export
 * @interface ComparedRun
 */
export interface ComparedRun {
    [key: string]: any | any;
    /**
     *
     */
    run_id: string;
    /**
     * Both runs have scored every episode.
     */
    complete: boolean;
    /**
     * Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
     */
    release: boolean;
    /**
     * Number of pairs.
     */
    paired: number;
    /**
     * Mean score of the baseline over the pairs.
     */
    baseline_mean: number | null;
    /**
     * Mean score of the run over the pairs.
     */
    mean: number | null;
    /**
     * Baseline minus run: positive when the run is worse.
     */
    difference: number | null;
    /**
     * Pairs in which the run alone succeeds.
     */
    wins: number;
    /**
     * Pairs in which the baseline alone succeeds.
     */
    losses: number;
    /**
     * Pairs in which both succeed or neither does.
     */
    ties: number;
    /**
     * McNemar's exact test, two-sided.
     */
    p_value: number;
    /**
     * Task → the pairs of its episodes.
     */
    by_task: { [key: string]: ComparedTask; };
}

/**
 * Check if a given object implements the ComparedRun interface.
 */
export function instanceOfComparedRun(value: object): value is ComparedRun {
    if (!('run_id' in value) || value['run_id'] === undefined) return false;
    if (!('complete' in value) || value['complete'] === undefined) return false;
    if (!('release' in value) || value['release'] === undefined) return false;
    if (!('paired' in value) || value['paired'] === undefined) return false;
    if (!('baseline_mean' in value) || value['baseline_mean'] === undefined) return false;
    if (!('mean' in value) || value['mean'] === undefined) return false;
    if (!('difference' in value) || value['difference'] === undefined) return false;
    if (!('wins' in value) || value['wins'] === undefined) return false;
    if (!('losses' in value) || value['losses'] === undefined) return false;
    if (!('ties' in value) || value['ties'] === undefined) return false;
    if (!('p_value' in value) || value['p_value'] === undefined) return false;
    if (!('by_task' in value) || value['by_task'] === undefined) return false;
    return true;
}

export function ComparedRunFromJSON(json: any): ComparedRun {
    return ComparedRunFromJSONTyped(json, false);
}

export function ComparedRunFromJSONTyped(json: any, ignoreDiscriminator: boolean): ComparedRun {
    if (json == null) {
        return json;
    }
    checkMembers('ComparedRun', json);
    return {

            ...json,
        'run_id': json['run_id'],
        'complete': json['complete'],
        'release': json['release'],
        'paired': json['paired'],
        'baseline_mean': json['baseline_mean'],
        'mean': json['mean'],
        'difference': json['difference'],
        'wins': json['wins'],
        'losses': json['losses'],
        'ties': json['ties'],
        'p_value': json['p_value'],
        'by_task': (mapValues(json['by_task'], ComparedTaskFromJSON)),
    };
}

export function ComparedRunToJSON(json: any): ComparedRun {
    return ComparedRunToJSONTyped(json, false);
}

export function ComparedRunToJSONTyped(value?: ComparedRun | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'run_id': value['run_id'],
        'complete': value['complete'],
        'release': value['release'],
        'paired': value['paired'],
        'baseline_mean': value['baseline_mean'],
        'mean': value['mean'],
        'difference': value['difference'],
        'wins': value['wins'],
        'losses': value['losses'],
        'ties': value['ties'],
        'p_value': value['p_value'],
        'by_task': (mapValues(value['by_task'], ComparedTaskToJSON)),
    };
}
