/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Assumptions } from './Assumptions';
import {
    AssumptionsFromJSON,
    AssumptionsFromJSONTyped,
    AssumptionsToJSON,
    AssumptionsToJSONTyped,
} from './Assumptions';
import type { ProtocolRange } from './ProtocolRange';
import {
    ProtocolRangeFromJSON,
    ProtocolRangeFromJSONTyped,
    ProtocolRangeToJSON,
    ProtocolRangeToJSONTyped,
} from './ProtocolRange';

/**
 * What a policy server says of itself; see policy.yaml.
 * @export
 * @interface PolicyDescription
 */
export interface PolicyDescription {
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
    protocol: ProtocolRange;
    /**
     * Most episodes that it plays at a time.
     */
    max_sessions: number;
    /**
     *
     */
    assumes?: Assumptions;
}

/**
 * Check if a given object implements the PolicyDescription interface.
 */
export function instanceOfPolicyDescription(value: object): value is PolicyDescription {
    if (!('name' in value) || value['name'] === undefined) return false;
    if (!('protocol' in value) || value['protocol'] === undefined) return false;
    if (!('max_sessions' in value) || value['max_sessions'] === undefined) return false;
    return true;
}

export function PolicyDescriptionFromJSON(json: any): PolicyDescription {
    return PolicyDescriptionFromJSONTyped(json, false);
}

export function PolicyDescriptionFromJSONTyped(json: any, ignoreDiscriminator: boolean): PolicyDescription {
    if (json == null) {
        return json;
    }
    checkMembers('PolicyDescription', json);
    return {

            ...json,
        'name': json['name'],
        'version': json['version'] == null ? undefined : json['version'],
        'protocol': ProtocolRangeFromJSON(json['protocol']),
        'max_sessions': json['max_sessions'],
        'assumes': json['assumes'] == null ? undefined : AssumptionsFromJSON(json['assumes']),
    };
}

export function PolicyDescriptionToJSON(json: any): PolicyDescription {
    return PolicyDescriptionToJSONTyped(json, false);
}

export function PolicyDescriptionToJSONTyped(value?: PolicyDescription | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'name': value['name'],
        'version': value['version'],
        'protocol': ProtocolRangeToJSON(value['protocol']),
        'max_sessions': value['max_sessions'],
        'assumes': AssumptionsToJSON(value['assumes']),
    };
}
