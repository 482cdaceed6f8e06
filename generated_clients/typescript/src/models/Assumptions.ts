/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Assumption } from './Assumption';
import {
    AssumptionFromJSON,
    AssumptionFromJSONTyped,
    AssumptionToJSON,
    AssumptionToJSONTyped,
} from './Assumption';

/**
 * What the policy takes for granted; refused when the benchmark says otherwise (ATT-010).
 * @export
 * @interface Assumptions
 */
export interface Assumptions {
    /**
     *
     */
    control_rate_hz?: number;
    /**
     *
     */
    action?: { [key: string]: Assumption; };
    /**
     *
     */
    state?: { [key: string]: Assumption; };
}

/**
 * Check if a given object implements the Assumptions interface.
 */
export function instanceOfAssumptions(value: object): value is Assumptions {
    return true;
}

export function AssumptionsFromJSON(json: any): Assumptions {
    return AssumptionsFromJSONTyped(json, false);
}

export function AssumptionsFromJSONTyped(json: any, ignoreDiscriminator: boolean): Assumptions {
    if (json == null) {
        return json;
    }
    checkMembers('Assumptions', json);
    return {

        'control_rate_hz': json['control_rate_hz'] == null ? undefined : json['control_rate_hz'],
        'action': json['action'] == null ? undefined : (mapValues(json['action'], AssumptionFromJSON)),
        'state': json['state'] == null ? undefined : (mapValues(json['state'], AssumptionFromJSON)),
    };
}

export function AssumptionsToJSON(json: any): Assumptions {
    return AssumptionsToJSONTyped(json, false);
}

export function AssumptionsToJSONTyped(value?: Assumptions | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'control_rate_hz': value['control_rate_hz'],
        'action': value['action'] == null ? undefined : (mapValues(value['action'], AssumptionToJSON)),
        'state': value['state'] == null ? undefined : (mapValues(value['state'], AssumptionToJSON)),
    };
}
