/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const RunState = {
    Queued: 'queued',
    Ready: 'ready',
    Running: 'running',
    Stopping: 'stopping',
    Stopped: 'stopped',
    Failed: 'failed',
    Completed: 'completed',
} as const;
export type RunState = typeof RunState[keyof typeof RunState];


export function instanceOfRunState(value: any): boolean {
    for (const key in RunState) {
        if (Object.prototype.hasOwnProperty.call(RunState, key)) {
            if (RunState[key as keyof typeof RunState] === value) {
                return true;
            }
        }
    }
    return false;
}

export function RunStateFromJSON(json: any): RunState {
    return RunStateFromJSONTyped(json, false);
}

export function RunStateFromJSONTyped(json: any, ignoreDiscriminator: boolean): RunState {
    return json as RunState;
}

export function RunStateToJSON(value?: RunState | null): any {
    return value as any;
}

export function RunStateToJSONTyped(value: any, ignoreDiscriminator: boolean): RunState {
    return value as RunState;
}
