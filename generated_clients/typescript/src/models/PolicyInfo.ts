/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 *
 * @export
 * @interface PolicyInfo
 */
export interface PolicyInfo {
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
    submitter?: string;
    /**
     *
     */
    homepage?: string;
}

/**
 * Check if a given object implements the PolicyInfo interface.
 */
export function instanceOfPolicyInfo(value: object): value is PolicyInfo {
    if (!('name' in value) || value['name'] === undefined) return false;
    return true;
}

export function PolicyInfoFromJSON(json: any): PolicyInfo {
    return PolicyInfoFromJSONTyped(json, false);
}

export function PolicyInfoFromJSONTyped(json: any, ignoreDiscriminator: boolean): PolicyInfo {
    if (json == null) {
        return json;
    }
    checkMembers('PolicyInfo', json);
    return {

        'name': json['name'],
        'version': json['version'] == null ? undefined : json['version'],
        'submitter': json['submitter'] == null ? undefined : json['submitter'],
        'homepage': json['homepage'] == null ? undefined : json['homepage'],
    };
}

export function PolicyInfoToJSON(json: any): PolicyInfo {
    return PolicyInfoToJSONTyped(json, false);
}

export function PolicyInfoToJSONTyped(value?: PolicyInfo | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'name': value['name'],
        'version': value['version'],
        'submitter': value['submitter'],
        'homepage': value['homepage'],
    };
}
