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
 * @interface SimulatorInfo
 */
export interface SimulatorInfo {
    [key: string]: any | any;
    /**
     *
     */
    name: string;
    /**
     *
     */
    version: string;
    /**
     * Named rendering quality, where there is one.
     */
    quality?: string;
}

/**
 * Check if a given object implements the SimulatorInfo interface.
 */
export function instanceOfSimulatorInfo(value: object): value is SimulatorInfo {
    if (!('name' in value) || value['name'] === undefined) return false;
    if (!('version' in value) || value['version'] === undefined) return false;
    return true;
}

export function SimulatorInfoFromJSON(json: any): SimulatorInfo {
    return SimulatorInfoFromJSONTyped(json, false);
}

export function SimulatorInfoFromJSONTyped(json: any, ignoreDiscriminator: boolean): SimulatorInfo {
    if (json == null) {
        return json;
    }
    checkMembers('SimulatorInfo', json);
    return {

            ...json,
        'name': json['name'],
        'version': json['version'],
        'quality': json['quality'] == null ? undefined : json['quality'],
    };
}

export function SimulatorInfoToJSON(json: any): SimulatorInfo {
    return SimulatorInfoToJSONTyped(json, false);
}

export function SimulatorInfoToJSONTyped(value?: SimulatorInfo | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'name': value['name'],
        'version': value['version'],
        'quality': value['quality'],
    };
}
