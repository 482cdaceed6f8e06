/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 * `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own.
 * @export
 */
export const RunMode = {
    Pull: 'pull',
    Push: 'push',
} as const;
export type RunMode = typeof RunMode[keyof typeof RunMode];


export function instanceOfRunMode(value: any): boolean {
    for (const key in RunMode) {
        if (Object.prototype.hasOwnProperty.call(RunMode, key)) {
            if (RunMode[key as keyof typeof RunMode] === value) {
                return true;
            }
        }
    }
    return false;
}

export function RunModeFromJSON(json: any): RunMode {
    return RunModeFromJSONTyped(json, false);
}

export function RunModeFromJSONTyped(json: any, ignoreDiscriminator: boolean): RunMode {
    return json as RunMode;
}

export function RunModeToJSON(value?: RunMode | null): any {
    return value as any;
}

export function RunModeToJSONTyped(value: any, ignoreDiscriminator: boolean): RunMode {
    return value as RunMode;
}
