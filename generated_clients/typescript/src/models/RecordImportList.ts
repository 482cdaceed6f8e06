/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { RecordImport } from './RecordImport';
import {
    RecordImportFromJSON,
    RecordImportFromJSONTyped,
    RecordImportToJSON,
    RecordImportToJSONTyped,
} from './RecordImport';

/**
 *
 * @export
 * @interface RecordImportList
 */
export interface RecordImportList {
    [key: string]: any | any;
    /**
     *
     */
    imports: Array<RecordImport>;
    /**
     *
     */
    next_cursor: string | null;
}

/**
 * Check if a given object implements the RecordImportList interface.
 */
export function instanceOfRecordImportList(value: object): value is RecordImportList {
    if (!('imports' in value) || value['imports'] === undefined) return false;
    if (!('next_cursor' in value) || value['next_cursor'] === undefined) return false;
    return true;
}

export function RecordImportListFromJSON(json: any): RecordImportList {
    return RecordImportListFromJSONTyped(json, false);
}

export function RecordImportListFromJSONTyped(json: any, ignoreDiscriminator: boolean): RecordImportList {
    if (json == null) {
        return json;
    }
    checkMembers('RecordImportList', json);
    return {

            ...json,
        'imports': ((json['imports'] as Array<any>).map(RecordImportFromJSON)),
        'next_cursor': json['next_cursor'],
    };
}

export function RecordImportListToJSON(json: any): RecordImportList {
    return RecordImportListToJSONTyped(json, false);
}

export function RecordImportListToJSONTyped(value?: RecordImportList | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'imports': ((value['imports'] as Array<any>).map(RecordImportToJSON)),
        'next_cursor': value['next_cursor'],
    };
}
