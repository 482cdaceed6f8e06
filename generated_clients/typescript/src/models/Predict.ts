/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Action } from './Action';
import {
    ActionFromJSON,
    ActionFromJSONTyped,
    ActionToJSON,
    ActionToJSONTyped,
} from './Action';
import type { Observe } from './Observe';
import {
    ObserveFromJSON,
    ObserveFromJSONTyped,
    ObserveToJSON,
    ObserveToJSONTyped,
} from './Observe';

/**
 *
 * @export
 * @interface Predict
 */
export interface Predict {
    /**
     *
     */
    session_id: string;
    /**
     *
     */
    seq: number;
    /**
     *
     */
    actions: Array<Action>;
    /**
     *
     */
    observe?: Observe;
}



/**
 * Check if a given object implements the Predict interface.
 */
export function instanceOfPredict(value: object): value is Predict {
    if (!('session_id' in value) || value['session_id'] === undefined) return false;
    if (!('seq' in value) || value['seq'] === undefined) return false;
    if (!('actions' in value) || value['actions'] === undefined) return false;
    return true;
}

export function PredictFromJSON(json: any): Predict {
    return PredictFromJSONTyped(json, false);
}

export function PredictFromJSONTyped(json: any, ignoreDiscriminator: boolean): Predict {
    if (json == null) {
        return json;
    }
    checkMembers('Predict', json);
    return {

        'session_id': json['session_id'],
        'seq': json['seq'],
        'actions': ((json['actions'] as Array<any>).map(ActionFromJSON)),
        'observe': json['observe'] == null ? undefined : ObserveFromJSON(json['observe']),
    };
}

export function PredictToJSON(json: any): Predict {
    return PredictToJSONTyped(json, false);
}

export function PredictToJSONTyped(value?: Predict | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'session_id': value['session_id'],
        'seq': value['seq'],
        'actions': ((value['actions'] as Array<any>).map(ActionToJSON)),
        'observe': ObserveToJSON(value['observe']),
    };
}
