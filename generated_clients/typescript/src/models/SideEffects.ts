/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const SideEffects = {
    None: 'none',
    Possible: 'possible',
} as const;
export type SideEffects = typeof SideEffects[keyof typeof SideEffects];


export function instanceOfSideEffects(value: any): boolean {
    for (const key in SideEffects) {
        if (Object.prototype.hasOwnProperty.call(SideEffects, key)) {
            if (SideEffects[key as keyof typeof SideEffects] === value) {
                return true;
            }
        }
    }
    return false;
}

export function SideEffectsFromJSON(json: any): SideEffects {
    return SideEffectsFromJSONTyped(json, false);
}

export function SideEffectsFromJSONTyped(json: any, ignoreDiscriminator: boolean): SideEffects {
    return json as SideEffects;
}

export function SideEffectsToJSON(value?: SideEffects | null): any {
    return value as any;
}

export function SideEffectsToJSONTyped(value: any, ignoreDiscriminator: boolean): SideEffects {
    return value as SideEffects;
}
