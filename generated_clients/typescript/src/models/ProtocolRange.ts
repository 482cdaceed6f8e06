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
 * @interface ProtocolRange
 */
export interface ProtocolRange {
    [key: string]: any | any;
    /**
     *
     */
    min: string;
    /**
     *
     */
    max: string;
}

/**
 * Check if a given object implements the ProtocolRange interface.
 */
export function instanceOfProtocolRange(value: object): value is ProtocolRange {
    if (!('min' in value) || value['min'] === undefined) return false;
    if (!('max' in value) || value['max'] === undefined) return false;
    return true;
}

export function ProtocolRangeFromJSON(json: any): ProtocolRange {
    return ProtocolRangeFromJSONTyped(json, false);
}

export function ProtocolRangeFromJSONTyped(json: any, ignoreDiscriminator: boolean): ProtocolRange {
    if (json == null) {
        return json;
    }
    checkMembers('ProtocolRange', json);
    return {

            ...json,
        'min': json['min'],
        'max': json['max'],
    };
}

export function ProtocolRangeToJSON(json: any): ProtocolRange {
    return ProtocolRangeToJSONTyped(json, false);
}

export function ProtocolRangeToJSONTyped(value?: ProtocolRange | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'min': value['min'],
        'max': value['max'],
    };
}
