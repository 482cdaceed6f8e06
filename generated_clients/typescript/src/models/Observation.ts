/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Tensor } from './Tensor';
import {
    TensorFromJSON,
    TensorFromJSONTyped,
    TensorToJSON,
    TensorToJSONTyped,
} from './Tensor';
import type { Image } from './Image';
import {
    ImageFromJSON,
    ImageFromJSONTyped,
    ImageToJSON,
    ImageToJSONTyped,
} from './Image';

/**
 *
 * @export
 * @interface Observation
 */
export interface Observation {
    [key: string]: any | any;
    /**
     *
     */
    state: { [key: string]: Array<number>; };
    /**
     *
     */
    images: { [key: string]: Image; };
    /**
     *
     */
    tensors: { [key: string]: Tensor; };
}

/**
 * Check if a given object implements the Observation interface.
 */
export function instanceOfObservation(value: object): value is Observation {
    if (!('state' in value) || value['state'] === undefined) return false;
    if (!('images' in value) || value['images'] === undefined) return false;
    if (!('tensors' in value) || value['tensors'] === undefined) return false;
    return true;
}

export function ObservationFromJSON(json: any): Observation {
    return ObservationFromJSONTyped(json, false);
}

export function ObservationFromJSONTyped(json: any, ignoreDiscriminator: boolean): Observation {
    if (json == null) {
        return json;
    }
    checkMembers('Observation', json);
    return {

            ...json,
        'state': json['state'],
        'images': (mapValues(json['images'], ImageFromJSON)),
        'tensors': (mapValues(json['tensors'], TensorFromJSON)),
    };
}

export function ObservationToJSON(json: any): Observation {
    return ObservationToJSONTyped(json, false);
}

export function ObservationToJSONTyped(value?: Observation | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'state': value['state'],
        'images': (mapValues(value['images'], ImageToJSON)),
        'tensors': (mapValues(value['tensors'], TensorToJSON)),
    };
}
