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
 * @interface ProblemItem
 */
export interface ProblemItem {
    [key: string]: any | any;
    /**
     * JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record.
     */
    pointer: string;
    /**
     *
     */
    detail: string;
}

/**
 * Check if a given object implements the ProblemItem interface.
 */
export function instanceOfProblemItem(value: object): value is ProblemItem {
    if (!('pointer' in value) || value['pointer'] === undefined) return false;
    if (!('detail' in value) || value['detail'] === undefined) return false;
    return true;
}

export function ProblemItemFromJSON(json: any): ProblemItem {
    return ProblemItemFromJSONTyped(json, false);
}

export function ProblemItemFromJSONTyped(json: any, ignoreDiscriminator: boolean): ProblemItem {
    if (json == null) {
        return json;
    }
    checkMembers('ProblemItem', json);
    return {

            ...json,
        'pointer': json['pointer'],
        'detail': json['detail'],
    };
}

export function ProblemItemToJSON(json: any): ProblemItem {
    return ProblemItemToJSONTyped(json, false);
}

export function ProblemItemToJSONTyped(value?: ProblemItem | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'pointer': value['pointer'],
        'detail': value['detail'],
    };
}
