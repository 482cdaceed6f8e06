/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 * What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
 * @export
 */
export const SessionEnd = {
    LeaseEnded: 'lease_ended',
    Detached: 'detached',
    RunStopped: 'run_stopped',
    RunFailed: 'run_failed',
    Unknown: 'unknown',
} as const;
export type SessionEnd = typeof SessionEnd[keyof typeof SessionEnd];


export function instanceOfSessionEnd(value: any): boolean {
    for (const key in SessionEnd) {
        if (Object.prototype.hasOwnProperty.call(SessionEnd, key)) {
            if (SessionEnd[key as keyof typeof SessionEnd] === value) {
                return true;
            }
        }
    }
    return false;
}

export function SessionEndFromJSON(json: any): SessionEnd {
    return SessionEndFromJSONTyped(json, false);
}

export function SessionEndFromJSONTyped(json: any, ignoreDiscriminator: boolean): SessionEnd {
    return json as SessionEnd;
}

export function SessionEndToJSON(value?: SessionEnd | null): any {
    return value as any;
}

export function SessionEndToJSONTyped(value: any, ignoreDiscriminator: boolean): SessionEnd {
    return value as SessionEnd;
}
