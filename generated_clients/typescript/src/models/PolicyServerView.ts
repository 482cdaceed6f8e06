/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The policy server of a run with mode `push`, with what was left open filled in, and without its key.
 * @export
 * @interface PolicyServerView
 */
export interface PolicyServerView {
    [key: string]: any | any;
    /**
     *
     */
    url: string;
    /**
     * A `PolicyProtocol`, or one of a later version.
     */
    protocol: string;
    /**
     *
     */
    has_api_key: boolean;
    /**
     *
     */
    model?: string;
    /**
     *
     */
    call_timeout_s: number;
    /**
     *
     */
    max_concurrent: number;
    /**
     *
     */
    max_retries: number;
    /**
     *
     */
    generation?: { [key: string]: number; };
}

/**
 * Check if a given object implements the PolicyServerView interface.
 */
export function instanceOfPolicyServerView(value: object): value is PolicyServerView {
    if (!('url' in value) || value['url'] === undefined) return false;
    if (!('protocol' in value) || value['protocol'] === undefined) return false;
    if (!('has_api_key' in value) || value['has_api_key'] === undefined) return false;
    if (!('call_timeout_s' in value) || value['call_timeout_s'] === undefined) return false;
    if (!('max_concurrent' in value) || value['max_concurrent'] === undefined) return false;
    if (!('max_retries' in value) || value['max_retries'] === undefined) return false;
    return true;
}

export function PolicyServerViewFromJSON(json: any): PolicyServerView {
    return PolicyServerViewFromJSONTyped(json, false);
}

export function PolicyServerViewFromJSONTyped(json: any, ignoreDiscriminator: boolean): PolicyServerView {
    if (json == null) {
        return json;
    }
    checkMembers('PolicyServerView', json);
    return {

            ...json,
        'url': json['url'],
        'protocol': json['protocol'],
        'has_api_key': json['has_api_key'],
        'model': json['model'] == null ? undefined : json['model'],
        'call_timeout_s': json['call_timeout_s'],
        'max_concurrent': json['max_concurrent'],
        'max_retries': json['max_retries'],
        'generation': json['generation'] == null ? undefined : json['generation'],
    };
}

export function PolicyServerViewToJSON(json: any): PolicyServerView {
    return PolicyServerViewToJSONTyped(json, false);
}

export function PolicyServerViewToJSONTyped(value?: PolicyServerView | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'url': value['url'],
        'protocol': value['protocol'],
        'has_api_key': value['has_api_key'],
        'model': value['model'],
        'call_timeout_s': value['call_timeout_s'],
        'max_concurrent': value['max_concurrent'],
        'max_retries': value['max_retries'],
        'generation': value['generation'],
    };
}
