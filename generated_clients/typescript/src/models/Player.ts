/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * Who plays, by its own words; for the profile `attribution`.
 * @export
 * @interface Player
 */
export interface Player {
    /**
     * Of the policy, as in `policy` of the run.
     */
    name: string;
    /**
     * Of the policy.
     */
    version?: string;
    /**
     * The program that attaches and its version.
     */
    client?: string;
}

/**
 * Check if a given object implements the Player interface.
 */
export function instanceOfPlayer(value: object): value is Player {
    if (!('name' in value) || value['name'] === undefined) return false;
    return true;
}

export function PlayerFromJSON(json: any): Player {
    return PlayerFromJSONTyped(json, false);
}

export function PlayerFromJSONTyped(json: any, ignoreDiscriminator: boolean): Player {
    if (json == null) {
        return json;
    }
    checkMembers('Player', json);
    return {

        'name': json['name'],
        'version': json['version'] == null ? undefined : json['version'],
        'client': json['client'] == null ? undefined : json['client'],
    };
}

export function PlayerToJSON(json: any): Player {
    return PlayerToJSONTyped(json, false);
}

export function PlayerToJSONTyped(value?: Player | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'name': value['name'],
        'version': value['version'],
        'client': value['client'],
    };
}
