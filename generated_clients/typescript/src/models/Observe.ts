/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 * `last` when absent; `all` adds the observation after every executed action.
 * @export
 */
export const Observe = {
    Last: 'last',
    All: 'all',
} as const;
export type Observe = typeof Observe[keyof typeof Observe];


export function instanceOfObserve(value: any): boolean {
    for (const key in Observe) {
        if (Object.prototype.hasOwnProperty.call(Observe, key)) {
            if (Observe[key as keyof typeof Observe] === value) {
                return true;
            }
        }
    }
    return false;
}

export function ObserveFromJSON(json: any): Observe {
    return ObserveFromJSONTyped(json, false);
}

export function ObserveFromJSONTyped(json: any, ignoreDiscriminator: boolean): Observe {
    return json as Observe;
}

export function ObserveToJSON(value?: Observe | null): any {
    return value as any;
}

export function ObserveToJSONTyped(value: any, ignoreDiscriminator: boolean): Observe {
    return value as Observe;
}
