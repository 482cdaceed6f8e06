/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { TensorSpace } from './TensorSpace';
import {
    TensorSpaceFromJSON,
    TensorSpaceFromJSONTyped,
    TensorSpaceToJSON,
    TensorSpaceToJSONTyped,
} from './TensorSpace';
import type { ImageSpace } from './ImageSpace';
import {
    ImageSpaceFromJSON,
    ImageSpaceFromJSONTyped,
    ImageSpaceToJSON,
    ImageSpaceToJSONTyped,
} from './ImageSpace';
import type { VectorSpace } from './VectorSpace';
import {
    VectorSpaceFromJSON,
    VectorSpaceFromJSONTyped,
    VectorSpaceToJSON,
    VectorSpaceToJSONTyped,
} from './VectorSpace';

/**
 *
 * @export
 * @interface ObservationSpace
 */
export interface ObservationSpace {
    [key: string]: any | any;
    /**
     *
     */
    state: { [key: string]: VectorSpace; };
    /**
     *
     */
    images: { [key: string]: ImageSpace; };
    /**
     *
     */
    tensors: { [key: string]: TensorSpace; };
}

/**
 * Check if a given object implements the ObservationSpace interface.
 */
export function instanceOfObservationSpace(value: object): value is ObservationSpace {
    if (!('state' in value) || value['state'] === undefined) return false;
    if (!('images' in value) || value['images'] === undefined) return false;
    if (!('tensors' in value) || value['tensors'] === undefined) return false;
    return true;
}

export function ObservationSpaceFromJSON(json: any): ObservationSpace {
    return ObservationSpaceFromJSONTyped(json, false);
}

export function ObservationSpaceFromJSONTyped(json: any, ignoreDiscriminator: boolean): ObservationSpace {
    if (json == null) {
        return json;
    }
    checkMembers('ObservationSpace', json);
    return {

            ...json,
        'state': (mapValues(json['state'], VectorSpaceFromJSON)),
        'images': (mapValues(json['images'], ImageSpaceFromJSON)),
        'tensors': (mapValues(json['tensors'], TensorSpaceFromJSON)),
    };
}

export function ObservationSpaceToJSON(json: any): ObservationSpace {
    return ObservationSpaceToJSONTyped(json, false);
}

export function ObservationSpaceToJSONTyped(value?: ObservationSpace | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'state': (mapValues(value['state'], VectorSpaceToJSON)),
        'images': (mapValues(value['images'], ImageSpaceToJSON)),
        'tensors': (mapValues(value['tensors'], TensorSpaceToJSON)),
    };
}
