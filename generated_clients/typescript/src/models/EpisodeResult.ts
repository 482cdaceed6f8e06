/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues, parseDate, parseDateTime, serializeDate, serializeDateTime } from '../runtime';
import { checkMembers } from '../shapes';
import type { Outcome } from './Outcome';
import {
    OutcomeFromJSON,
    OutcomeFromJSONTyped,
    OutcomeToJSON,
    OutcomeToJSONTyped,
} from './Outcome';
import type { PlayerView } from './PlayerView';
import {
    PlayerViewFromJSON,
    PlayerViewFromJSONTyped,
    PlayerViewToJSON,
    PlayerViewToJSONTyped,
} from './PlayerView';

/**
 *
 * @export
 * @interface EpisodeResult
 */
export interface EpisodeResult {
    [key: string]: any | any;
    /**
     *
     */
    episode_id: string;
    /**
     *
     */
    index: number;
    /**
     *
     */
    task: string;
    /**
     *
     */
    split: string;
    /**
     * Absent where `sealed_splits` of the benchmark names the split.
     */
    seed?: number;
    /**
     *
     */
    attempt: number;
    /**
     *
     */
    faults: number;
    /**
     *
     */
    outcome: Outcome;
    /**
     *
     */
    score: number;
    /**
     *
     */
    steps: number;
    /**
     *
     */
    terminated: boolean;
    /**
     *
     */
    truncated: boolean;
    /**
     * Time between turns that the policy took.
     */
    think_s: number;
    /**
     *
     */
    finished_at: Date;
    /**
     *
     */
    player?: PlayerView;
    /**
     * Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`.
     */
    clipped_actions?: number;
    /**
     * Sum of the rewards of the attempt, its return; for the profile `attribution`.
     */
    total_reward?: number;
}



/**
 * Check if a given object implements the EpisodeResult interface.
 */
export function instanceOfEpisodeResult(value: object): value is EpisodeResult {
    if (!('episode_id' in value) || value['episode_id'] === undefined) return false;
    if (!('index' in value) || value['index'] === undefined) return false;
    if (!('task' in value) || value['task'] === undefined) return false;
    if (!('split' in value) || value['split'] === undefined) return false;
    if (!('attempt' in value) || value['attempt'] === undefined) return false;
    if (!('faults' in value) || value['faults'] === undefined) return false;
    if (!('outcome' in value) || value['outcome'] === undefined) return false;
    if (!('score' in value) || value['score'] === undefined) return false;
    if (!('steps' in value) || value['steps'] === undefined) return false;
    if (!('terminated' in value) || value['terminated'] === undefined) return false;
    if (!('truncated' in value) || value['truncated'] === undefined) return false;
    if (!('think_s' in value) || value['think_s'] === undefined) return false;
    if (!('finished_at' in value) || value['finished_at'] === undefined) return false;
    return true;
}

export function EpisodeResultFromJSON(json: any): EpisodeResult {
    return EpisodeResultFromJSONTyped(json, false);
}

export function EpisodeResultFromJSONTyped(json: any, ignoreDiscriminator: boolean): EpisodeResult {
    if (json == null) {
        return json;
    }
    checkMembers('EpisodeResult', json);
    return {

            ...json,
        'episode_id': json['episode_id'],
        'index': json['index'],
        'task': json['task'],
        'split': json['split'],
        'seed': json['seed'] == null ? undefined : json['seed'],
        'attempt': json['attempt'],
        'faults': json['faults'],
        'outcome': OutcomeFromJSON(json['outcome']),
        'score': json['score'],
        'steps': json['steps'],
        'terminated': json['terminated'],
        'truncated': json['truncated'],
        'think_s': json['think_s'],
        'finished_at': (json['finished_at'] == null ? json['finished_at'] : parseDateTime(json['finished_at'])),
        'player': json['player'] == null ? undefined : PlayerViewFromJSON(json['player']),
        'clipped_actions': json['clipped_actions'] == null ? undefined : json['clipped_actions'],
        'total_reward': json['total_reward'] == null ? undefined : json['total_reward'],
    };
}

export function EpisodeResultToJSON(json: any): EpisodeResult {
    return EpisodeResultToJSONTyped(json, false);
}

export function EpisodeResultToJSONTyped(value?: EpisodeResult | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'episode_id': value['episode_id'],
        'index': value['index'],
        'task': value['task'],
        'split': value['split'],
        'seed': value['seed'],
        'attempt': value['attempt'],
        'faults': value['faults'],
        'outcome': OutcomeToJSON(value['outcome']),
        'score': value['score'],
        'steps': value['steps'],
        'terminated': value['terminated'],
        'truncated': value['truncated'],
        'think_s': value['think_s'],
        'finished_at': value['finished_at'] == null ? value['finished_at'] : serializeDateTime(value['finished_at']),
        'player': PlayerViewToJSON(value['player']),
        'clipped_actions': value['clipped_actions'],
        'total_reward': value['total_reward'],
    };
}
