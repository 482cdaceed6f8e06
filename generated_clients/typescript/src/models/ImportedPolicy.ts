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
 * @interface ImportedPolicy
 */
export interface ImportedPolicy {
    [key: string]: any | any;
    /**
     *
     */
    name: string;
    /**
     *
     */
    version: string | null;
}

/**
 * Check if a given object implements the ImportedPolicy interface.
 */
export function instanceOfImportedPolicy(value: object): value is ImportedPolicy {
    if (!('name' in value) || value['name'] === undefined) return false;
    if (!('version' in value) || value['version'] === undefined) return false;
    return true;
}

export function ImportedPolicyFromJSON(json: any): ImportedPolicy {
    return ImportedPolicyFromJSONTyped(json, false);
}

export function ImportedPolicyFromJSONTyped(json: any, ignoreDiscriminator: boolean): ImportedPolicy {
    if (json == null) {
        return json;
    }
    checkMembers('ImportedPolicy', json);
    return {

            ...json,
        'name': json['name'],
        'version': json['version'],
    };
}

export function ImportedPolicyToJSON(json: any): ImportedPolicy {
    return ImportedPolicyToJSONTyped(json, false);
}

export function ImportedPolicyToJSONTyped(value?: ImportedPolicy | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'name': value['name'],
        'version': value['version'],
    };
}
