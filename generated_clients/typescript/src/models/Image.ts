/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * RGB or grey, row 0 on top; raw is height × width × channels bytes.
 * @export
 * @interface Image
 */
export interface Image {
    [key: string]: any | any;
    /**
     *
     */
    codec: string;
    /**
     *
     */
    width: number;
    /**
     *
     */
    height: number;
    /**
     *
     */
    channels: number;
    /**
     * Base64 with padding in JSON; `bin` in MessagePack.
     */
    data: string;
}

/**
 * Check if a given object implements the Image interface.
 */
export function instanceOfImage(value: object): value is Image {
    if (!('codec' in value) || value['codec'] === undefined) return false;
    if (!('width' in value) || value['width'] === undefined) return false;
    if (!('height' in value) || value['height'] === undefined) return false;
    if (!('channels' in value) || value['channels'] === undefined) return false;
    if (!('data' in value) || value['data'] === undefined) return false;
    return true;
}

export function ImageFromJSON(json: any): Image {
    return ImageFromJSONTyped(json, false);
}

export function ImageFromJSONTyped(json: any, ignoreDiscriminator: boolean): Image {
    if (json == null) {
        return json;
    }
    checkMembers('Image', json);
    return {

            ...json,
        'codec': json['codec'],
        'width': json['width'],
        'height': json['height'],
        'channels': json['channels'],
        'data': json['data'],
    };
}

export function ImageToJSON(json: any): Image {
    return ImageToJSONTyped(json, false);
}

export function ImageToJSONTyped(value?: Image | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'codec': value['codec'],
        'width': value['width'],
        'height': value['height'],
        'channels': value['channels'],
        'data': value['data'],
    };
}
