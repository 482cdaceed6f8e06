/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * One named vector of numbers, with every convention a policy could get wrong.
 * @export
 * @interface VectorSpace
 */
export interface VectorSpace {
    [key: string]: any | any;
    /**
     *
     */
    size: number;
    /**
     * `rad`, `m`, `1`, or several joined by commas.
     */
    unit: string;
    /**
     *
     */
    rotation: string;
    /**
     * `world`, `base`, `tool`, `joint`, or `none`.
     */
    frame: string;
    /**
     * True when the values are increments.
     */
    relative: boolean;
    /**
     * The value that means fully open.
     */
    gripper_open?: number;
    /**
     *
     */
    minimum?: Array<number>;
    /**
     *
     */
    maximum?: Array<number>;
    /**
     *
     */
    out_of_range: string;
    /**
     * What the numbers are.
     */
    description?: string;
    /**
     * The tasks that have this entry; all of them when absent.
     */
    tasks?: Array<string>;
}

/**
 * Check if a given object implements the VectorSpace interface.
 */
export function instanceOfVectorSpace(value: object): value is VectorSpace {
    if (!('size' in value) || value['size'] === undefined) return false;
    if (!('unit' in value) || value['unit'] === undefined) return false;
    if (!('rotation' in value) || value['rotation'] === undefined) return false;
    if (!('frame' in value) || value['frame'] === undefined) return false;
    if (!('relative' in value) || value['relative'] === undefined) return false;
    if (!('out_of_range' in value) || value['out_of_range'] === undefined) return false;
    return true;
}

export function VectorSpaceFromJSON(json: any): VectorSpace {
    return VectorSpaceFromJSONTyped(json, false);
}

export function VectorSpaceFromJSONTyped(json: any, ignoreDiscriminator: boolean): VectorSpace {
    if (json == null) {
        return json;
    }
    checkMembers('VectorSpace', json);
    return {

            ...json,
        'size': json['size'],
        'unit': json['unit'],
        'rotation': json['rotation'],
        'frame': json['frame'],
        'relative': json['relative'],
        'gripper_open': json['gripper_open'] == null ? undefined : json['gripper_open'],
        'minimum': json['minimum'] == null ? undefined : json['minimum'],
        'maximum': json['maximum'] == null ? undefined : json['maximum'],
        'out_of_range': json['out_of_range'],
        'description': json['description'] == null ? undefined : json['description'],
        'tasks': json['tasks'] == null ? undefined : json['tasks'],
    };
}

export function VectorSpaceToJSON(json: any): VectorSpace {
    return VectorSpaceToJSONTyped(json, false);
}

export function VectorSpaceToJSONTyped(value?: VectorSpace | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'size': value['size'],
        'unit': value['unit'],
        'rotation': value['rotation'],
        'frame': value['frame'],
        'relative': value['relative'],
        'gripper_open': value['gripper_open'],
        'minimum': value['minimum'],
        'maximum': value['maximum'],
        'out_of_range': value['out_of_range'],
        'description': value['description'],
        'tasks': value['tasks'],
    };
}
