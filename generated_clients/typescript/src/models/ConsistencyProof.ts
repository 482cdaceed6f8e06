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
 * @interface ConsistencyProof
 */
export interface ConsistencyProof {
    [key: string]: any | any;
    /**
     *
     */
    old_size: number;
    /**
     *
     */
    new_size: number;
    /**
     *
     */
    hashes: Array<string>;
}

/**
 * Check if a given object implements the ConsistencyProof interface.
 */
export function instanceOfConsistencyProof(value: object): value is ConsistencyProof {
    if (!('old_size' in value) || value['old_size'] === undefined) return false;
    if (!('new_size' in value) || value['new_size'] === undefined) return false;
    if (!('hashes' in value) || value['hashes'] === undefined) return false;
    return true;
}

export function ConsistencyProofFromJSON(json: any): ConsistencyProof {
    return ConsistencyProofFromJSONTyped(json, false);
}

export function ConsistencyProofFromJSONTyped(json: any, ignoreDiscriminator: boolean): ConsistencyProof {
    if (json == null) {
        return json;
    }
    checkMembers('ConsistencyProof', json);
    return {

            ...json,
        'old_size': json['old_size'],
        'new_size': json['new_size'],
        'hashes': json['hashes'],
    };
}

export function ConsistencyProofToJSON(json: any): ConsistencyProof {
    return ConsistencyProofToJSONTyped(json, false);
}

export function ConsistencyProofToJSONTyped(value?: ConsistencyProof | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'old_size': value['old_size'],
        'new_size': value['new_size'],
        'hashes': value['hashes'],
    };
}
