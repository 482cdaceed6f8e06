/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { EpisodeStatus } from './EpisodeStatus';
import {
    EpisodeStatusFromJSON,
    EpisodeStatusFromJSONTyped,
    EpisodeStatusToJSON,
    EpisodeStatusToJSONTyped,
} from './EpisodeStatus';
import type { EpisodeResult } from './EpisodeResult';
import {
    EpisodeResultFromJSON,
    EpisodeResultFromJSONTyped,
    EpisodeResultToJSON,
    EpisodeResultToJSONTyped,
} from './EpisodeResult';

/**
 *
 * @export
 * @interface Episode
 */
export interface Episode {
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
     *
     */
    status: EpisodeStatus;
    /**
     * The current or next attempt.
     */
    attempt: number;
    /**
     *
     */
    faults: number;
    /**
     * In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode.
     */
    policy_fault?: string;
    /**
     *
     */
    result?: EpisodeResult;
}



/**
 * Check if a given object implements the Episode interface.
 */
export function instanceOfEpisode(value: object): value is Episode {
    if (!('episode_id' in value) || value['episode_id'] === undefined) return false;
    if (!('index' in value) || value['index'] === undefined) return false;
    if (!('task' in value) || value['task'] === undefined) return false;
    if (!('split' in value) || value['split'] === undefined) return false;
    if (!('status' in value) || value['status'] === undefined) return false;
    if (!('attempt' in value) || value['attempt'] === undefined) return false;
    if (!('faults' in value) || value['faults'] === undefined) return false;
    return true;
}

export function EpisodeFromJSON(json: any): Episode {
    return EpisodeFromJSONTyped(json, false);
}

export function EpisodeFromJSONTyped(json: any, ignoreDiscriminator: boolean): Episode {
    if (json == null) {
        return json;
    }
    checkMembers('Episode', json);
    return {

            ...json,
        'episode_id': json['episode_id'],
        'index': json['index'],
        'task': json['task'],
        'split': json['split'],
        'status': EpisodeStatusFromJSON(json['status']),
        'attempt': json['attempt'],
        'faults': json['faults'],
        'policy_fault': json['policy_fault'] == null ? undefined : json['policy_fault'],
        'result': json['result'] == null ? undefined : EpisodeResultFromJSON(json['result']),
    };
}

export function EpisodeToJSON(json: any): Episode {
    return EpisodeToJSONTyped(json, false);
}

export function EpisodeToJSONTyped(value?: Episode | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'episode_id': value['episode_id'],
        'index': value['index'],
        'task': value['task'],
        'split': value['split'],
        'status': EpisodeStatusToJSON(value['status']),
        'attempt': value['attempt'],
        'faults': value['faults'],
        'policy_fault': value['policy_fault'],
        'result': EpisodeResultToJSON(value['result']),
    };
}
