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
 * @interface Heartbeat
 */
export interface Heartbeat {
    /**
     *
     */
    session_id: string;
}

/**
 * Check if a given object implements the Heartbeat interface.
 */
export function instanceOfHeartbeat(value: object): value is Heartbeat {
    if (!('session_id' in value) || value['session_id'] === undefined) return false;
    return true;
}

export function HeartbeatFromJSON(json: any): Heartbeat {
    return HeartbeatFromJSONTyped(json, false);
}

export function HeartbeatFromJSONTyped(json: any, ignoreDiscriminator: boolean): Heartbeat {
    if (json == null) {
        return json;
    }
    checkMembers('Heartbeat', json);
    return {

        'session_id': json['session_id'],
    };
}

export function HeartbeatToJSON(json: any): Heartbeat {
    return HeartbeatToJSONTyped(json, false);
}

export function HeartbeatToJSONTyped(value?: Heartbeat | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'session_id': value['session_id'],
    };
}
