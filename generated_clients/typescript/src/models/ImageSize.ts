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
 * @interface ImageSize
 */
export interface ImageSize {
    [key: string]: any | any;
    /**
     *
     */
    width: number;
    /**
     *
     */
    height: number;
}

/**
 * Check if a given object implements the ImageSize interface.
 */
export function instanceOfImageSize(value: object): value is ImageSize {
    if (!('width' in value) || value['width'] === undefined) return false;
    if (!('height' in value) || value['height'] === undefined) return false;
    return true;
}

export function ImageSizeFromJSON(json: any): ImageSize {
    return ImageSizeFromJSONTyped(json, false);
}

export function ImageSizeFromJSONTyped(json: any, ignoreDiscriminator: boolean): ImageSize {
    if (json == null) {
        return json;
    }
    checkMembers('ImageSize', json);
    return {

            ...json,
        'width': json['width'],
        'height': json['height'],
    };
}

export function ImageSizeToJSON(json: any): ImageSize {
    return ImageSizeToJSONTyped(json, false);
}

export function ImageSizeToJSONTyped(value?: ImageSize | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'width': value['width'],
        'height': value['height'],
    };
}
