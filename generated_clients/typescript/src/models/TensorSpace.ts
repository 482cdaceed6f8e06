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
 * @interface TensorSpace
 */
export interface TensorSpace {
    [key: string]: any | any;
    /**
     *
     */
    dtype: string;
    /**
     *
     */
    shape: Array<number>;
    /**
     *
     */
    description: string;
    /**
     *
     */
    tasks?: Array<string>;
}

/**
 * Check if a given object implements the TensorSpace interface.
 */
export function instanceOfTensorSpace(value: object): value is TensorSpace {
    if (!('dtype' in value) || value['dtype'] === undefined) return false;
    if (!('shape' in value) || value['shape'] === undefined) return false;
    if (!('description' in value) || value['description'] === undefined) return false;
    return true;
}

export function TensorSpaceFromJSON(json: any): TensorSpace {
    return TensorSpaceFromJSONTyped(json, false);
}

export function TensorSpaceFromJSONTyped(json: any, ignoreDiscriminator: boolean): TensorSpace {
    if (json == null) {
        return json;
    }
    checkMembers('TensorSpace', json);
    return {

            ...json,
        'dtype': json['dtype'],
        'shape': json['shape'],
        'description': json['description'],
        'tasks': json['tasks'] == null ? undefined : json['tasks'],
    };
}

export function TensorSpaceToJSON(json: any): TensorSpace {
    return TensorSpaceToJSONTyped(json, false);
}

export function TensorSpaceToJSONTyped(value?: TensorSpace | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'dtype': value['dtype'],
        'shape': value['shape'],
        'description': value['description'],
        'tasks': value['tasks'],
    };
}
