/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { StopMode } from './StopMode';
import {
    StopModeFromJSON,
    StopModeFromJSONTyped,
    StopModeToJSON,
    StopModeToJSONTyped,
} from './StopMode';

/**
 *
 * @export
 * @interface StopRun
 */
export interface StopRun {
    /**
     *
     */
    mode?: StopMode;
}



/**
 * Check if a given object implements the StopRun interface.
 */
export function instanceOfStopRun(value: object): value is StopRun {
    return true;
}

export function StopRunFromJSON(json: any): StopRun {
    return StopRunFromJSONTyped(json, false);
}

export function StopRunFromJSONTyped(json: any, ignoreDiscriminator: boolean): StopRun {
    if (json == null) {
        return json;
    }
    checkMembers('StopRun', json);
    return {

        'mode': json['mode'] == null ? undefined : StopModeFromJSON(json['mode']),
    };
}

export function StopRunToJSON(json: any): StopRun {
    return StopRunToJSONTyped(json, false);
}

export function StopRunToJSONTyped(value?: StopRun | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'mode': StopModeToJSON(value['mode']),
    };
}
