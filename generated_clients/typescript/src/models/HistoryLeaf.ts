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
 * @interface HistoryLeaf
 */
export interface HistoryLeaf {
    [key: string]: any | any;
    /**
     *
     */
    index: number;
    /**
     * A JSON text, whose UTF-8 is what the tree has; board.md has its members.
     */
    leaf: string;
}

/**
 * Check if a given object implements the HistoryLeaf interface.
 */
export function instanceOfHistoryLeaf(value: object): value is HistoryLeaf {
    if (!('index' in value) || value['index'] === undefined) return false;
    if (!('leaf' in value) || value['leaf'] === undefined) return false;
    return true;
}

export function HistoryLeafFromJSON(json: any): HistoryLeaf {
    return HistoryLeafFromJSONTyped(json, false);
}

export function HistoryLeafFromJSONTyped(json: any, ignoreDiscriminator: boolean): HistoryLeaf {
    if (json == null) {
        return json;
    }
    checkMembers('HistoryLeaf', json);
    return {

            ...json,
        'index': json['index'],
        'leaf': json['leaf'],
    };
}

export function HistoryLeafToJSON(json: any): HistoryLeaf {
    return HistoryLeafToJSONTyped(json, false);
}

export function HistoryLeafToJSONTyped(value?: HistoryLeaf | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'index': value['index'],
        'leaf': value['leaf'],
    };
}
