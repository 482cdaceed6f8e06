/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * C order, little-endian; a bool is one byte, 0 or 1.
 * @export
 * @interface Tensor
 */
export interface Tensor {
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
     * Base64 with padding in JSON; `bin` in MessagePack.
     */
    data: string;
}

/**
 * Check if a given object implements the Tensor interface.
 */
export function instanceOfTensor(value: object): value is Tensor {
    if (!('dtype' in value) || value['dtype'] === undefined) return false;
    if (!('shape' in value) || value['shape'] === undefined) return false;
    if (!('data' in value) || value['data'] === undefined) return false;
    return true;
}

export function TensorFromJSON(json: any): Tensor {
    return TensorFromJSONTyped(json, false);
}

export function TensorFromJSONTyped(json: any, ignoreDiscriminator: boolean): Tensor {
    if (json == null) {
        return json;
    }
    checkMembers('Tensor', json);
    return {

            ...json,
        'dtype': json['dtype'],
        'shape': json['shape'],
        'data': json['data'],
    };
}

export function TensorToJSON(json: any): Tensor {
    return TensorToJSONTyped(json, false);
}

export function TensorToJSONTyped(value?: Tensor | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'dtype': value['dtype'],
        'shape': value['shape'],
        'data': value['data'],
    };
}
