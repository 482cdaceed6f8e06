/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const ImageCodec = {
    Raw: 'raw',
    Png: 'png',
    Jpeg: 'jpeg',
} as const;
export type ImageCodec = typeof ImageCodec[keyof typeof ImageCodec];


export function instanceOfImageCodec(value: any): boolean {
    for (const key in ImageCodec) {
        if (Object.prototype.hasOwnProperty.call(ImageCodec, key)) {
            if (ImageCodec[key as keyof typeof ImageCodec] === value) {
                return true;
            }
        }
    }
    return false;
}

export function ImageCodecFromJSON(json: any): ImageCodec {
    return ImageCodecFromJSONTyped(json, false);
}

export function ImageCodecFromJSONTyped(json: any, ignoreDiscriminator: boolean): ImageCodec {
    return json as ImageCodec;
}

export function ImageCodecToJSON(value?: ImageCodec | null): any {
    return value as any;
}

export function ImageCodecToJSONTyped(value: any, ignoreDiscriminator: boolean): ImageCodec {
    return value as ImageCodec;
}
