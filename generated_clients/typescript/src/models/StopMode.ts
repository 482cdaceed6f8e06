/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 * `abort` when absent.
 * @export
 */
export const StopMode = {
    Abort: 'abort',
    Drain: 'drain',
} as const;
export type StopMode = typeof StopMode[keyof typeof StopMode];


export function instanceOfStopMode(value: any): boolean {
    for (const key in StopMode) {
        if (Object.prototype.hasOwnProperty.call(StopMode, key)) {
            if (StopMode[key as keyof typeof StopMode] === value) {
                return true;
            }
        }
    }
    return false;
}

export function StopModeFromJSON(json: any): StopMode {
    return StopModeFromJSONTyped(json, false);
}

export function StopModeFromJSONTyped(json: any, ignoreDiscriminator: boolean): StopMode {
    return json as StopMode;
}

export function StopModeToJSON(value?: StopMode | null): any {
    return value as any;
}

export function StopModeToJSONTyped(value: any, ignoreDiscriminator: boolean): StopMode {
    return value as StopMode;
}
