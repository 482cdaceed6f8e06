/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * Recorded with the result, because it changes the score.
 * @export
 * @interface ImageChoice
 */
export interface ImageChoice {
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
}

/**
 * Check if a given object implements the ImageChoice interface.
 */
export function instanceOfImageChoice(value: object): value is ImageChoice {
    if (!('codec' in value) || value['codec'] === undefined) return false;
    if (!('width' in value) || value['width'] === undefined) return false;
    if (!('height' in value) || value['height'] === undefined) return false;
    return true;
}

export function ImageChoiceFromJSON(json: any): ImageChoice {
    return ImageChoiceFromJSONTyped(json, false);
}

export function ImageChoiceFromJSONTyped(json: any, ignoreDiscriminator: boolean): ImageChoice {
    if (json == null) {
        return json;
    }
    checkMembers('ImageChoice', json);
    return {

        'codec': json['codec'],
        'width': json['width'],
        'height': json['height'],
    };
}

export function ImageChoiceToJSON(json: any): ImageChoice {
    return ImageChoiceToJSONTyped(json, false);
}

export function ImageChoiceToJSONTyped(value?: ImageChoice | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'codec': value['codec'],
        'width': value['width'],
        'height': value['height'],
    };
}
