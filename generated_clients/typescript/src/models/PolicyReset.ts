/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The policy is ready for this attempt and no other.
 * @export
 * @interface PolicyReset
 */
export interface PolicyReset {
    [key: string]: any | any;
    /**
     *
     */
    session_id: string;
    /**
     *
     */
    episode_id: string;
    /**
     *
     */
    attempt: number;
}

/**
 * Check if a given object implements the PolicyReset interface.
 */
export function instanceOfPolicyReset(value: object): value is PolicyReset {
    if (!('session_id' in value) || value['session_id'] === undefined) return false;
    if (!('episode_id' in value) || value['episode_id'] === undefined) return false;
    if (!('attempt' in value) || value['attempt'] === undefined) return false;
    return true;
}

export function PolicyResetFromJSON(json: any): PolicyReset {
    return PolicyResetFromJSONTyped(json, false);
}

export function PolicyResetFromJSONTyped(json: any, ignoreDiscriminator: boolean): PolicyReset {
    if (json == null) {
        return json;
    }
    checkMembers('PolicyReset', json);
    return {

            ...json,
        'session_id': json['session_id'],
        'episode_id': json['episode_id'],
        'attempt': json['attempt'],
    };
}

export function PolicyResetToJSON(json: any): PolicyReset {
    return PolicyResetToJSONTyped(json, false);
}

export function PolicyResetToJSONTyped(value?: PolicyReset | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'session_id': value['session_id'],
        'episode_id': value['episode_id'],
        'attempt': value['attempt'],
    };
}
