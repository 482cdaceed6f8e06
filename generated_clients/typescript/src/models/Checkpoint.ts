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
 * @interface Checkpoint
 */
export interface Checkpoint {
    [key: string]: any | any;
    /**
     *
     */
    tree_size: number;
    /**
     * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
     */
    root_sha256: string;
    /**
     * The signed note, which says both as well.
     */
    note: string;
    /**
     * Of the key of `list_keys` that signed it.
     */
    keyid: string;
}

/**
 * Check if a given object implements the Checkpoint interface.
 */
export function instanceOfCheckpoint(value: object): value is Checkpoint {
    if (!('tree_size' in value) || value['tree_size'] === undefined) return false;
    if (!('root_sha256' in value) || value['root_sha256'] === undefined) return false;
    if (!('note' in value) || value['note'] === undefined) return false;
    if (!('keyid' in value) || value['keyid'] === undefined) return false;
    return true;
}

export function CheckpointFromJSON(json: any): Checkpoint {
    return CheckpointFromJSONTyped(json, false);
}

export function CheckpointFromJSONTyped(json: any, ignoreDiscriminator: boolean): Checkpoint {
    if (json == null) {
        return json;
    }
    checkMembers('Checkpoint', json);
    return {

            ...json,
        'tree_size': json['tree_size'],
        'root_sha256': json['root_sha256'],
        'note': json['note'],
        'keyid': json['keyid'],
    };
}

export function CheckpointToJSON(json: any): Checkpoint {
    return CheckpointToJSONTyped(json, false);
}

export function CheckpointToJSONTyped(value?: Checkpoint | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'tree_size': value['tree_size'],
        'root_sha256': value['root_sha256'],
        'note': value['note'],
        'keyid': value['keyid'],
    };
}
