/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Player } from './Player';
import {
    PlayerFromJSON,
    PlayerFromJSONTyped,
    PlayerToJSON,
    PlayerToJSONTyped,
} from './Player';
import type { Assumptions } from './Assumptions';
import {
    AssumptionsFromJSON,
    AssumptionsFromJSONTyped,
    AssumptionsToJSON,
    AssumptionsToJSONTyped,
} from './Assumptions';

/**
 *
 * @export
 * @interface AttachWorker
 */
export interface AttachWorker {
    /**
     * New for every attachment; repeated only to repeat a lost request.
     */
    attach_key: string;
    /**
     * Fence out a live session; false when absent.
     */
    takeover?: boolean;
    /**
     *
     */
    assumes?: Assumptions;
    /**
     *
     */
    player?: Player;
}

/**
 * Check if a given object implements the AttachWorker interface.
 */
export function instanceOfAttachWorker(value: object): value is AttachWorker {
    if (!('attach_key' in value) || value['attach_key'] === undefined) return false;
    return true;
}

export function AttachWorkerFromJSON(json: any): AttachWorker {
    return AttachWorkerFromJSONTyped(json, false);
}

export function AttachWorkerFromJSONTyped(json: any, ignoreDiscriminator: boolean): AttachWorker {
    if (json == null) {
        return json;
    }
    checkMembers('AttachWorker', json);
    return {

        'attach_key': json['attach_key'],
        'takeover': json['takeover'] == null ? undefined : json['takeover'],
        'assumes': json['assumes'] == null ? undefined : AssumptionsFromJSON(json['assumes']),
        'player': json['player'] == null ? undefined : PlayerFromJSON(json['player']),
    };
}

export function AttachWorkerToJSON(json: any): AttachWorker {
    return AttachWorkerToJSONTyped(json, false);
}

export function AttachWorkerToJSONTyped(value?: AttachWorker | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'attach_key': value['attach_key'],
        'takeover': value['takeover'],
        'assumes': AssumptionsToJSON(value['assumes']),
        'player': PlayerToJSON(value['player']),
    };
}
