/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const Dtype = {
    Bool: 'bool',
    Int8: 'int8',
    Int16: 'int16',
    Int32: 'int32',
    Int64: 'int64',
    Uint8: 'uint8',
    Uint16: 'uint16',
    Uint32: 'uint32',
    Uint64: 'uint64',
    Float16: 'float16',
    Float32: 'float32',
    Float64: 'float64',
} as const;
export type Dtype = typeof Dtype[keyof typeof Dtype];


export function instanceOfDtype(value: any): boolean {
    for (const key in Dtype) {
        if (Object.prototype.hasOwnProperty.call(Dtype, key)) {
            if (Dtype[key as keyof typeof Dtype] === value) {
                return true;
            }
        }
    }
    return false;
}

export function DtypeFromJSON(json: any): Dtype {
    return DtypeFromJSONTyped(json, false);
}

export function DtypeFromJSONTyped(json: any, ignoreDiscriminator: boolean): Dtype {
    return json as Dtype;
}

export function DtypeToJSON(value?: Dtype | null): any {
    return value as any;
}

export function DtypeToJSONTyped(value: any, ignoreDiscriminator: boolean): Dtype {
    return value as Dtype;
}
