/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


/**
 *
 * @export
 */
export const SuccessRule = {
    AnyStep: 'any_step',
    LastStep: 'last_step',
} as const;
export type SuccessRule = typeof SuccessRule[keyof typeof SuccessRule];


export function instanceOfSuccessRule(value: any): boolean {
    for (const key in SuccessRule) {
        if (Object.prototype.hasOwnProperty.call(SuccessRule, key)) {
            if (SuccessRule[key as keyof typeof SuccessRule] === value) {
                return true;
            }
        }
    }
    return false;
}

export function SuccessRuleFromJSON(json: any): SuccessRule {
    return SuccessRuleFromJSONTyped(json, false);
}

export function SuccessRuleFromJSONTyped(json: any, ignoreDiscriminator: boolean): SuccessRule {
    return json as SuccessRule;
}

export function SuccessRuleToJSON(value?: SuccessRule | null): any {
    return value as any;
}

export function SuccessRuleToJSONTyped(value: any, ignoreDiscriminator: boolean): SuccessRule {
    return value as SuccessRule;
}
