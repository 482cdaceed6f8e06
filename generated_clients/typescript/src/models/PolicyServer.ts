/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { PolicyProtocol } from './PolicyProtocol';
import {
    PolicyProtocolFromJSON,
    PolicyProtocolFromJSONTyped,
    PolicyProtocolToJSON,
    PolicyProtocolToJSONTyped,
} from './PolicyProtocol';

/**
 * Where the server finds the policy of a run with mode `push`, and how it calls it.
 * @export
 * @interface PolicyServer
 */
export interface PolicyServer {
    /**
     * Base URL, without user, query or fragment; the path of an operation is appended to it.
     */
    url: string;
    /**
     *
     */
    protocol: PolicyProtocol;
    /**
     * Sent as bearer token with every call, and never shown.
     */
    api_key?: string;
    /**
     * Which model is asked, where a protocol knows several.
     */
    model?: string;
    /**
     * Time for one call, from connecting to the last byte of its answer; 30 when absent.
     */
    call_timeout_s?: number;
    /**
     * Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
     */
    max_concurrent?: number;
    /**
     * How often a call that was not answered is repeated; 3 when absent.
     */
    max_retries?: number;
    /**
     * Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone.
     */
    generation?: { [key: string]: number; };
}



/**
 * Check if a given object implements the PolicyServer interface.
 */
export function instanceOfPolicyServer(value: object): value is PolicyServer {
    if (!('url' in value) || value['url'] === undefined) return false;
    if (!('protocol' in value) || value['protocol'] === undefined) return false;
    return true;
}

export function PolicyServerFromJSON(json: any): PolicyServer {
    return PolicyServerFromJSONTyped(json, false);
}

export function PolicyServerFromJSONTyped(json: any, ignoreDiscriminator: boolean): PolicyServer {
    if (json == null) {
        return json;
    }
    checkMembers('PolicyServer', json);
    return {

        'url': json['url'],
        'protocol': PolicyProtocolFromJSON(json['protocol']),
        'api_key': json['api_key'] == null ? undefined : json['api_key'],
        'model': json['model'] == null ? undefined : json['model'],
        'call_timeout_s': json['call_timeout_s'] == null ? undefined : json['call_timeout_s'],
        'max_concurrent': json['max_concurrent'] == null ? undefined : json['max_concurrent'],
        'max_retries': json['max_retries'] == null ? undefined : json['max_retries'],
        'generation': json['generation'] == null ? undefined : json['generation'],
    };
}

export function PolicyServerToJSON(json: any): PolicyServer {
    return PolicyServerToJSONTyped(json, false);
}

export function PolicyServerToJSONTyped(value?: PolicyServer | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'url': value['url'],
        'protocol': PolicyProtocolToJSON(value['protocol']),
        'api_key': value['api_key'],
        'model': value['model'],
        'call_timeout_s': value['call_timeout_s'],
        'max_concurrent': value['max_concurrent'],
        'max_retries': value['max_retries'],
        'generation': value['generation'],
    };
}
