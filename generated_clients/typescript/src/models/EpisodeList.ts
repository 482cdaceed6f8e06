/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Episode } from './Episode';
import {
    EpisodeFromJSON,
    EpisodeFromJSONTyped,
    EpisodeToJSON,
    EpisodeToJSONTyped,
} from './Episode';

/**
 *
 * @export
 * @interface EpisodeList
 */
export interface EpisodeList {
    [key: string]: any | any;
    /**
     *
     */
    episodes: Array<Episode>;
    /**
     *
     */
    next_cursor: string | null;
}

/**
 * Check if a given object implements the EpisodeList interface.
 */
export function instanceOfEpisodeList(value: object): value is EpisodeList {
    if (!('episodes' in value) || value['episodes'] === undefined) return false;
    if (!('next_cursor' in value) || value['next_cursor'] === undefined) return false;
    return true;
}

export function EpisodeListFromJSON(json: any): EpisodeList {
    return EpisodeListFromJSONTyped(json, false);
}

export function EpisodeListFromJSONTyped(json: any, ignoreDiscriminator: boolean): EpisodeList {
    if (json == null) {
        return json;
    }
    checkMembers('EpisodeList', json);
    return {

            ...json,
        'episodes': ((json['episodes'] as Array<any>).map(EpisodeFromJSON)),
        'next_cursor': json['next_cursor'],
    };
}

export function EpisodeListToJSON(json: any): EpisodeList {
    return EpisodeListToJSONTyped(json, false);
}

export function EpisodeListToJSONTyped(value?: EpisodeList | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'episodes': ((value['episodes'] as Array<any>).map(EpisodeToJSON)),
        'next_cursor': value['next_cursor'],
    };
}
