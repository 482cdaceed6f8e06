/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { HistoryLeaf } from './HistoryLeaf';
import {
    HistoryLeafFromJSON,
    HistoryLeafFromJSONTyped,
    HistoryLeafToJSON,
    HistoryLeafToJSONTyped,
} from './HistoryLeaf';

/**
 *
 * @export
 * @interface HistoryPage
 */
export interface HistoryPage {
    [key: string]: any | any;
    /**
     *
     */
    leaves: Array<HistoryLeaf>;
    /**
     *
     */
    next_cursor: string | null;
}

/**
 * Check if a given object implements the HistoryPage interface.
 */
export function instanceOfHistoryPage(value: object): value is HistoryPage {
    if (!('leaves' in value) || value['leaves'] === undefined) return false;
    if (!('next_cursor' in value) || value['next_cursor'] === undefined) return false;
    return true;
}

export function HistoryPageFromJSON(json: any): HistoryPage {
    return HistoryPageFromJSONTyped(json, false);
}

export function HistoryPageFromJSONTyped(json: any, ignoreDiscriminator: boolean): HistoryPage {
    if (json == null) {
        return json;
    }
    checkMembers('HistoryPage', json);
    return {

            ...json,
        'leaves': ((json['leaves'] as Array<any>).map(HistoryLeafFromJSON)),
        'next_cursor': json['next_cursor'],
    };
}

export function HistoryPageToJSON(json: any): HistoryPage {
    return HistoryPageToJSONTyped(json, false);
}

export function HistoryPageToJSONTyped(value?: HistoryPage | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'leaves': ((value['leaves'] as Array<any>).map(HistoryLeafToJSON)),
        'next_cursor': value['next_cursor'],
    };
}
