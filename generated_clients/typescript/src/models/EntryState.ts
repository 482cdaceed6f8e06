/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const EntryState = {
    Published: 'published',
    Withdrawn: 'withdrawn',
} as const;
export type EntryState = typeof EntryState[keyof typeof EntryState];


export function instanceOfEntryState(value: any): boolean {
    for (const key in EntryState) {
        if (Object.prototype.hasOwnProperty.call(EntryState, key)) {
            if (EntryState[key as keyof typeof EntryState] === value) {
                return true;
            }
        }
    }
    return false;
}

export function EntryStateFromJSON(json: any): EntryState {
    return EntryStateFromJSONTyped(json, false);
}

export function EntryStateFromJSONTyped(json: any, ignoreDiscriminator: boolean): EntryState {
    return json as EntryState;
}

export function EntryStateToJSON(value?: EntryState | null): any {
    return value as any;
}

export function EntryStateToJSONTyped(value: any, ignoreDiscriminator: boolean): EntryState {
    return value as EntryState;
}
