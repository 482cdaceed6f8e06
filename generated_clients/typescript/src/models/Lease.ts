/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues, parseDate, parseDateTime, serializeDate, serializeDateTime } from '../runtime';
import { checkMembers } from '../shapes';
/**
 *
 * @export
 * @interface Lease
 */
export interface Lease {
    [key: string]: any | any;
    /**
     *
     */
    expires_at: Date;
    /**
     *
     */
    idle_timeout_s: number;
}

/**
 * Check if a given object implements the Lease interface.
 */
export function instanceOfLease(value: object): value is Lease {
    if (!('expires_at' in value) || value['expires_at'] === undefined) return false;
    if (!('idle_timeout_s' in value) || value['idle_timeout_s'] === undefined) return false;
    return true;
}

export function LeaseFromJSON(json: any): Lease {
    return LeaseFromJSONTyped(json, false);
}

export function LeaseFromJSONTyped(json: any, ignoreDiscriminator: boolean): Lease {
    if (json == null) {
        return json;
    }
    checkMembers('Lease', json);
    return {

            ...json,
        'expires_at': (json['expires_at'] == null ? json['expires_at'] : parseDateTime(json['expires_at'])),
        'idle_timeout_s': json['idle_timeout_s'],
    };
}

export function LeaseToJSON(json: any): Lease {
    return LeaseToJSONTyped(json, false);
}

export function LeaseToJSONTyped(value?: Lease | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'expires_at': value['expires_at'] == null ? value['expires_at'] : serializeDateTime(value['expires_at']),
        'idle_timeout_s': value['idle_timeout_s'],
    };
}
