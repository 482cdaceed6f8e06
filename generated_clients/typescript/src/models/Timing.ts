/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
/**
 * Server time of this turn, in seconds.
 * @export
 * @interface Timing
 */
export interface Timing {
    [key: string]: any | any;
    /**
     *
     */
    total_s: number;
    /**
     *
     */
    queue_s: number;
    /**
     *
     */
    simulate_s: number;
    /**
     *
     */
    render_s: number;
    /**
     * Encoding of images.
     */
    encode_s: number;
}

/**
 * Check if a given object implements the Timing interface.
 */
export function instanceOfTiming(value: object): value is Timing {
    if (!('total_s' in value) || value['total_s'] === undefined) return false;
    if (!('queue_s' in value) || value['queue_s'] === undefined) return false;
    if (!('simulate_s' in value) || value['simulate_s'] === undefined) return false;
    if (!('render_s' in value) || value['render_s'] === undefined) return false;
    if (!('encode_s' in value) || value['encode_s'] === undefined) return false;
    return true;
}

export function TimingFromJSON(json: any): Timing {
    return TimingFromJSONTyped(json, false);
}

export function TimingFromJSONTyped(json: any, ignoreDiscriminator: boolean): Timing {
    if (json == null) {
        return json;
    }
    checkMembers('Timing', json);
    return {

            ...json,
        'total_s': json['total_s'],
        'queue_s': json['queue_s'],
        'simulate_s': json['simulate_s'],
        'render_s': json['render_s'],
        'encode_s': json['encode_s'],
    };
}

export function TimingToJSON(json: any): Timing {
    return TimingToJSONTyped(json, false);
}

export function TimingToJSONTyped(value?: Timing | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'total_s': value['total_s'],
        'queue_s': value['queue_s'],
        'simulate_s': value['simulate_s'],
        'render_s': value['render_s'],
        'encode_s': value['encode_s'],
    };
}
