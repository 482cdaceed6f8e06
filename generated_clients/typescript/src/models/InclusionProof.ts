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
 * @interface InclusionProof
 */
export interface InclusionProof {
    [key: string]: any | any;
    /**
     *
     */
    leaf_index: number;
    /**
     *
     */
    tree_size: number;
    /**
     *
     */
    hashes: Array<string>;
}

/**
 * Check if a given object implements the InclusionProof interface.
 */
export function instanceOfInclusionProof(value: object): value is InclusionProof {
    if (!('leaf_index' in value) || value['leaf_index'] === undefined) return false;
    if (!('tree_size' in value) || value['tree_size'] === undefined) return false;
    if (!('hashes' in value) || value['hashes'] === undefined) return false;
    return true;
}

export function InclusionProofFromJSON(json: any): InclusionProof {
    return InclusionProofFromJSONTyped(json, false);
}

export function InclusionProofFromJSONTyped(json: any, ignoreDiscriminator: boolean): InclusionProof {
    if (json == null) {
        return json;
    }
    checkMembers('InclusionProof', json);
    return {

            ...json,
        'leaf_index': json['leaf_index'],
        'tree_size': json['tree_size'],
        'hashes': json['hashes'],
    };
}

export function InclusionProofToJSON(json: any): InclusionProof {
    return InclusionProofToJSONTyped(json, false);
}

export function InclusionProofToJSONTyped(value?: InclusionProof | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'leaf_index': value['leaf_index'],
        'tree_size': value['tree_size'],
        'hashes': value['hashes'],
    };
}
