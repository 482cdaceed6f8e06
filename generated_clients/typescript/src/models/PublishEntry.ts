/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * What an entry says of itself; a member that is absent is not shown.
 * @export
 * @interface PublishEntry
 */
export interface PublishEntry {
    /**
     *
     */
    model_name: string;
    /**
     * Whether others see the entry, and whether it has a rank.
     */
    is_public: boolean;
    /**
     * What kind of model it is, for example `VLA` or `diffusion policy`.
     */
    model_type?: string;
    /**
     *
     */
    organisation?: string;
    /**
     *
     */
    homepage?: string;
    /**
     *
     */
    code_url?: string;
    /**
     *
     */
    notes?: string;
}

/**
 * Check if a given object implements the PublishEntry interface.
 */
export function instanceOfPublishEntry(value: object): value is PublishEntry {
    if (!('model_name' in value) || value['model_name'] === undefined) return false;
    if (!('is_public' in value) || value['is_public'] === undefined) return false;
    return true;
}

export function PublishEntryFromJSON(json: any): PublishEntry {
    return PublishEntryFromJSONTyped(json, false);
}

export function PublishEntryFromJSONTyped(json: any, ignoreDiscriminator: boolean): PublishEntry {
    if (json == null) {
        return json;
    }
    checkMembers('PublishEntry', json);
    return {

        'model_name': json['model_name'],
        'is_public': json['is_public'],
        'model_type': json['model_type'] == null ? undefined : json['model_type'],
        'organisation': json['organisation'] == null ? undefined : json['organisation'],
        'homepage': json['homepage'] == null ? undefined : json['homepage'],
        'code_url': json['code_url'] == null ? undefined : json['code_url'],
        'notes': json['notes'] == null ? undefined : json['notes'],
    };
}

export function PublishEntryToJSON(json: any): PublishEntry {
    return PublishEntryToJSONTyped(json, false);
}

export function PublishEntryToJSONTyped(value?: PublishEntry | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'model_name': value['model_name'],
        'is_public': value['is_public'],
        'model_type': value['model_type'],
        'organisation': value['organisation'],
        'homepage': value['homepage'],
        'code_url': value['code_url'],
        'notes': value['notes'],
    };
}
