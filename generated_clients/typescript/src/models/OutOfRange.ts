/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const OutOfRange = {
    Refuse: 'refuse',
    Clip: 'clip',
    Unbounded: 'unbounded',
} as const;
export type OutOfRange = typeof OutOfRange[keyof typeof OutOfRange];


export function instanceOfOutOfRange(value: any): boolean {
    for (const key in OutOfRange) {
        if (Object.prototype.hasOwnProperty.call(OutOfRange, key)) {
            if (OutOfRange[key as keyof typeof OutOfRange] === value) {
                return true;
            }
        }
    }
    return false;
}

export function OutOfRangeFromJSON(json: any): OutOfRange {
    return OutOfRangeFromJSONTyped(json, false);
}

export function OutOfRangeFromJSONTyped(json: any, ignoreDiscriminator: boolean): OutOfRange {
    return json as OutOfRange;
}

export function OutOfRangeToJSON(value?: OutOfRange | null): any {
    return value as any;
}

export function OutOfRangeToJSONTyped(value: any, ignoreDiscriminator: boolean): OutOfRange {
    return value as OutOfRange;
}
