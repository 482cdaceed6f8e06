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
 * @interface PublicKey
 */
export interface PublicKey {
    [key: string]: any | any;
    /**
     * `SHA256:` and the SHA-256 of the key in hexadecimal digits.
     */
    keyid: string;
    /**
     * `ed25519`, or another one of a later version.
     */
    algorithm: string;
    /**
     * Its 32 bytes.
     */
    public_key: string;
    /**
     *
     */
    created_at: Date;
    /**
     * When it signed for the last time; null for the key in use.
     */
    retired_at: Date | null;
}

/**
 * Check if a given object implements the PublicKey interface.
 */
export function instanceOfPublicKey(value: object): value is PublicKey {
    if (!('keyid' in value) || value['keyid'] === undefined) return false;
    if (!('algorithm' in value) || value['algorithm'] === undefined) return false;
    if (!('public_key' in value) || value['public_key'] === undefined) return false;
    if (!('created_at' in value) || value['created_at'] === undefined) return false;
    if (!('retired_at' in value) || value['retired_at'] === undefined) return false;
    return true;
}

export function PublicKeyFromJSON(json: any): PublicKey {
    return PublicKeyFromJSONTyped(json, false);
}

export function PublicKeyFromJSONTyped(json: any, ignoreDiscriminator: boolean): PublicKey {
    if (json == null) {
        return json;
    }
    checkMembers('PublicKey', json);
    return {

            ...json,
        'keyid': json['keyid'],
        'algorithm': json['algorithm'],
        'public_key': json['public_key'],
        'created_at': (json['created_at'] == null ? json['created_at'] : parseDateTime(json['created_at'])),
        'retired_at': (json['retired_at'] == null ? null : parseDateTime(json['retired_at'])),
    };
}

export function PublicKeyToJSON(json: any): PublicKey {
    return PublicKeyToJSONTyped(json, false);
}

export function PublicKeyToJSONTyped(value?: PublicKey | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'keyid': value['keyid'],
        'algorithm': value['algorithm'],
        'public_key': value['public_key'],
        'created_at': value['created_at'] == null ? value['created_at'] : serializeDateTime(value['created_at']),
        'retired_at': value['retired_at'] == null ? value['retired_at'] : serializeDateTime(value['retired_at']),
    };
}
