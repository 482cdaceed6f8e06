/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The first state that was another one; absent where every state was met.
 * @export
 * @interface ReplayDivergence
 */
export interface ReplayDivergence {
    [key: string]: any | any;
    /**
     *
     */
    episode_index: number;
    /**
     *
     */
    attempt: number;
    /**
     * After how many steps of the attempt the state was another one.
     */
    step: number;
}

/**
 * Check if a given object implements the ReplayDivergence interface.
 */
export function instanceOfReplayDivergence(value: object): value is ReplayDivergence {
    if (!('episode_index' in value) || value['episode_index'] === undefined) return false;
    if (!('attempt' in value) || value['attempt'] === undefined) return false;
    if (!('step' in value) || value['step'] === undefined) return false;
    return true;
}

export function ReplayDivergenceFromJSON(json: any): ReplayDivergence {
    return ReplayDivergenceFromJSONTyped(json, false);
}

export function ReplayDivergenceFromJSONTyped(json: any, ignoreDiscriminator: boolean): ReplayDivergence {
    if (json == null) {
        return json;
    }
    checkMembers('ReplayDivergence', json);
    return {

            ...json,
        'episode_index': json['episode_index'],
        'attempt': json['attempt'],
        'step': json['step'],
    };
}

export function ReplayDivergenceToJSON(json: any): ReplayDivergence {
    return ReplayDivergenceToJSONTyped(json, false);
}

export function ReplayDivergenceToJSONTyped(value?: ReplayDivergence | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'episode_index': value['episode_index'],
        'attempt': value['attempt'],
        'step': value['step'],
    };
}
