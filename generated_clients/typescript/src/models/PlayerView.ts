/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The `player` of an `attach_worker`.
 * @export
 * @interface PlayerView
 */
export interface PlayerView {
    [key: string]: any | any;
    /**
     *
     */
    name: string;
    /**
     *
     */
    version?: string;
    /**
     *
     */
    client?: string;
}

/**
 * Check if a given object implements the PlayerView interface.
 */
export function instanceOfPlayerView(value: object): value is PlayerView {
    if (!('name' in value) || value['name'] === undefined) return false;
    return true;
}

export function PlayerViewFromJSON(json: any): PlayerView {
    return PlayerViewFromJSONTyped(json, false);
}

export function PlayerViewFromJSONTyped(json: any, ignoreDiscriminator: boolean): PlayerView {
    if (json == null) {
        return json;
    }
    checkMembers('PlayerView', json);
    return {

            ...json,
        'name': json['name'],
        'version': json['version'] == null ? undefined : json['version'],
        'client': json['client'] == null ? undefined : json['client'],
    };
}

export function PlayerViewToJSON(json: any): PlayerView {
    return PlayerViewToJSONTyped(json, false);
}

export function PlayerViewToJSONTyped(value?: PlayerView | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'name': value['name'],
        'version': value['version'],
        'client': value['client'],
    };
}
