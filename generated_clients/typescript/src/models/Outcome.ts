/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const Outcome = {
    Success: 'success',
    Failure: 'failure',
    Abandoned: 'abandoned',
} as const;
export type Outcome = typeof Outcome[keyof typeof Outcome];


export function instanceOfOutcome(value: any): boolean {
    for (const key in Outcome) {
        if (Object.prototype.hasOwnProperty.call(Outcome, key)) {
            if (Outcome[key as keyof typeof Outcome] === value) {
                return true;
            }
        }
    }
    return false;
}

export function OutcomeFromJSON(json: any): Outcome {
    return OutcomeFromJSONTyped(json, false);
}

export function OutcomeFromJSONTyped(json: any, ignoreDiscriminator: boolean): Outcome {
    return json as Outcome;
}

export function OutcomeToJSON(value?: Outcome | null): any {
    return value as any;
}

export function OutcomeToJSONTyped(value: any, ignoreDiscriminator: boolean): Outcome {
    return value as Outcome;
}
