/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 *
 * @export
 * @interface Assumption
 */
export interface Assumption {
    /**
     *
     */
    size?: number;
    /**
     *
     */
    unit?: string;
    /**
     *
     */
    rotation?: string;
    /**
     *
     */
    frame?: string;
    /**
     *
     */
    relative?: boolean;
    /**
     *
     */
    gripper_open?: number;
}

/**
 * Check if a given object implements the Assumption interface.
 */
export function instanceOfAssumption(value: object): value is Assumption {
    return true;
}

export function AssumptionFromJSON(json: any): Assumption {
    return AssumptionFromJSONTyped(json, false);
}

export function AssumptionFromJSONTyped(json: any, ignoreDiscriminator: boolean): Assumption {
    if (json == null) {
        return json;
    }
    checkMembers('Assumption', json);
    return {

        'size': json['size'] == null ? undefined : json['size'],
        'unit': json['unit'] == null ? undefined : json['unit'],
        'rotation': json['rotation'] == null ? undefined : json['rotation'],
        'frame': json['frame'] == null ? undefined : json['frame'],
        'relative': json['relative'] == null ? undefined : json['relative'],
        'gripper_open': json['gripper_open'] == null ? undefined : json['gripper_open'],
    };
}

export function AssumptionToJSON(json: any): Assumption {
    return AssumptionToJSONTyped(json, false);
}

export function AssumptionToJSONTyped(value?: Assumption | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'size': value['size'],
        'unit': value['unit'],
        'rotation': value['rotation'],
        'frame': value['frame'],
        'relative': value['relative'],
        'gripper_open': value['gripper_open'],
    };
}
