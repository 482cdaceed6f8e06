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
 * @interface ImageSpace
 */
export interface ImageSpace {
    [key: string]: any | any;
    /**
     *
     */
    channels: number;
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
 * Check if a given object implements the ImageSpace interface.
 */
export function instanceOfImageSpace(value: object): value is ImageSpace {
    if (!('channels' in value) || value['channels'] === undefined) return false;
    if (!('description' in value) || value['description'] === undefined) return false;
    return true;
}

export function ImageSpaceFromJSON(json: any): ImageSpace {
    return ImageSpaceFromJSONTyped(json, false);
}

export function ImageSpaceFromJSONTyped(json: any, ignoreDiscriminator: boolean): ImageSpace {
    if (json == null) {
        return json;
    }
    checkMembers('ImageSpace', json);
    return {

            ...json,
        'channels': json['channels'],
        'description': json['description'],
        'tasks': json['tasks'] == null ? undefined : json['tasks'],
    };
}

export function ImageSpaceToJSON(json: any): ImageSpace {
    return ImageSpaceToJSONTyped(json, false);
}

export function ImageSpaceToJSONTyped(value?: ImageSpace | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'channels': value['channels'],
        'description': value['description'],
        'tasks': value['tasks'],
    };
}
