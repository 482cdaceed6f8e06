/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`.
 * @export
 * @interface EpisodeSelection
 */
export interface EpisodeSelection {
    /**
     *
     */
    tasks?: Array<string>;
    /**
     *
     */
    splits?: Array<string>;
}

/**
 * Check if a given object implements the EpisodeSelection interface.
 */
export function instanceOfEpisodeSelection(value: object): value is EpisodeSelection {
    return true;
}

export function EpisodeSelectionFromJSON(json: any): EpisodeSelection {
    return EpisodeSelectionFromJSONTyped(json, false);
}

export function EpisodeSelectionFromJSONTyped(json: any, ignoreDiscriminator: boolean): EpisodeSelection {
    if (json == null) {
        return json;
    }
    checkMembers('EpisodeSelection', json);
    return {

        'tasks': json['tasks'] == null ? undefined : json['tasks'],
        'splits': json['splits'] == null ? undefined : json['splits'],
    };
}

export function EpisodeSelectionToJSON(json: any): EpisodeSelection {
    return EpisodeSelectionToJSONTyped(json, false);
}

export function EpisodeSelectionToJSONTyped(value?: EpisodeSelection | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'tasks': value['tasks'],
        'splits': value['splits'],
    };
}
