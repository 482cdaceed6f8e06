/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { PublicKey } from './PublicKey';
import {
    PublicKeyFromJSON,
    PublicKeyFromJSONTyped,
    PublicKeyToJSON,
    PublicKeyToJSONTyped,
} from './PublicKey';

/**
 *
 * @export
 * @interface KeyList
 */
export interface KeyList {
    [key: string]: any | any;
    /**
     *
     */
    keys: Array<PublicKey>;
}

/**
 * Check if a given object implements the KeyList interface.
 */
export function instanceOfKeyList(value: object): value is KeyList {
    if (!('keys' in value) || value['keys'] === undefined) return false;
    return true;
}

export function KeyListFromJSON(json: any): KeyList {
    return KeyListFromJSONTyped(json, false);
}

export function KeyListFromJSONTyped(json: any, ignoreDiscriminator: boolean): KeyList {
    if (json == null) {
        return json;
    }
    checkMembers('KeyList', json);
    return {

            ...json,
        'keys': ((json['keys'] as Array<any>).map(PublicKeyFromJSON)),
    };
}

export function KeyListToJSON(json: any): KeyList {
    return KeyListToJSONTyped(json, false);
}

export function KeyListToJSONTyped(value?: KeyList | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'keys': ((value['keys'] as Array<any>).map(PublicKeyToJSON)),
    };
}
