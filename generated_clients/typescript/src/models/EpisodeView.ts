/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The episode that the observation belongs to.
 * @export
 * @interface EpisodeView
 */
export interface EpisodeView {
    [key: string]: any | any;
    /**
     *
     */
    episode_id: string;
    /**
     * Position in the manifest.
     */
    index: number;
    /**
     *
     */
    task: string;
    /**
     *
     */
    instruction: string;
    /**
     *
     */
    attempt: number;
    /**
     *
     */
    step: number;
    /**
     *
     */
    max_steps: number;
}

/**
 * Check if a given object implements the EpisodeView interface.
 */
export function instanceOfEpisodeView(value: object): value is EpisodeView {
    if (!('episode_id' in value) || value['episode_id'] === undefined) return false;
    if (!('index' in value) || value['index'] === undefined) return false;
    if (!('task' in value) || value['task'] === undefined) return false;
    if (!('instruction' in value) || value['instruction'] === undefined) return false;
    if (!('attempt' in value) || value['attempt'] === undefined) return false;
    if (!('step' in value) || value['step'] === undefined) return false;
    if (!('max_steps' in value) || value['max_steps'] === undefined) return false;
    return true;
}

export function EpisodeViewFromJSON(json: any): EpisodeView {
    return EpisodeViewFromJSONTyped(json, false);
}

export function EpisodeViewFromJSONTyped(json: any, ignoreDiscriminator: boolean): EpisodeView {
    if (json == null) {
        return json;
    }
    checkMembers('EpisodeView', json);
    return {

            ...json,
        'episode_id': json['episode_id'],
        'index': json['index'],
        'task': json['task'],
        'instruction': json['instruction'],
        'attempt': json['attempt'],
        'step': json['step'],
        'max_steps': json['max_steps'],
    };
}

export function EpisodeViewToJSON(json: any): EpisodeView {
    return EpisodeViewToJSONTyped(json, false);
}

export function EpisodeViewToJSONTyped(value?: EpisodeView | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'episode_id': value['episode_id'],
        'index': value['index'],
        'task': value['task'],
        'instruction': value['instruction'],
        'attempt': value['attempt'],
        'step': value['step'],
        'max_steps': value['max_steps'],
    };
}
