/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one.
 * @export
 * @interface Fault
 */
export interface Fault {
    [key: string]: any | any;
    /**
     *
     */
    episode_id: string;
    /**
     * Faults of this episode so far.
     */
    faults: number;
    /**
     *
     */
    detail: string;
}

/**
 * Check if a given object implements the Fault interface.
 */
export function instanceOfFault(value: object): value is Fault {
    if (!('episode_id' in value) || value['episode_id'] === undefined) return false;
    if (!('faults' in value) || value['faults'] === undefined) return false;
    if (!('detail' in value) || value['detail'] === undefined) return false;
    return true;
}

export function FaultFromJSON(json: any): Fault {
    return FaultFromJSONTyped(json, false);
}

export function FaultFromJSONTyped(json: any, ignoreDiscriminator: boolean): Fault {
    if (json == null) {
        return json;
    }
    checkMembers('Fault', json);
    return {

            ...json,
        'episode_id': json['episode_id'],
        'faults': json['faults'],
        'detail': json['detail'],
    };
}

export function FaultToJSON(json: any): Fault {
    return FaultToJSONTyped(json, false);
}

export function FaultToJSONTyped(value?: Fault | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'episode_id': value['episode_id'],
        'faults': value['faults'],
        'detail': value['detail'],
    };
}
