/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues, parseDate, parseDateTime, serializeDate, serializeDateTime } from '../runtime';
import { checkMembers } from '../shapes';
import type { Limits } from './Limits';
import {
    LimitsFromJSON,
    LimitsFromJSONTyped,
    LimitsToJSON,
    LimitsToJSONTyped,
} from './Limits';
import type { ProtocolRange } from './ProtocolRange';
import {
    ProtocolRangeFromJSON,
    ProtocolRangeFromJSONTyped,
    ProtocolRangeToJSON,
    ProtocolRangeToJSONTyped,
} from './ProtocolRange';

/**
 * What a server says of itself before anyone authenticates.
 * @export
 * @interface Service
 */
export interface Service {
    [key: string]: any | any;
    /**
     *
     */
    name: string;
    /**
     * Version of the server software.
     */
    version: string;
    /**
     *
     */
    protocol: ProtocolRange;
    /**
     * Parts of the protocol offered; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these.
     */
    profiles: Array<string>;
    /**
     *
     */
    limits: Limits;
    /**
     * Media types of the data plane.
     */
    encodings: Array<string>;
    /**
     *
     */
    image_codecs: Array<string>;
    /**
     * The server's clock, UTC.
     */
    server_time: Date;
}

/**
 * Check if a given object implements the Service interface.
 */
export function instanceOfService(value: object): value is Service {
    if (!('name' in value) || value['name'] === undefined) return false;
    if (!('version' in value) || value['version'] === undefined) return false;
    if (!('protocol' in value) || value['protocol'] === undefined) return false;
    if (!('profiles' in value) || value['profiles'] === undefined) return false;
    if (!('limits' in value) || value['limits'] === undefined) return false;
    if (!('encodings' in value) || value['encodings'] === undefined) return false;
    if (!('image_codecs' in value) || value['image_codecs'] === undefined) return false;
    if (!('server_time' in value) || value['server_time'] === undefined) return false;
    return true;
}

export function ServiceFromJSON(json: any): Service {
    return ServiceFromJSONTyped(json, false);
}

export function ServiceFromJSONTyped(json: any, ignoreDiscriminator: boolean): Service {
    if (json == null) {
        return json;
    }
    checkMembers('Service', json);
    return {

            ...json,
        'name': json['name'],
        'version': json['version'],
        'protocol': ProtocolRangeFromJSON(json['protocol']),
        'profiles': json['profiles'],
        'limits': LimitsFromJSON(json['limits']),
        'encodings': json['encodings'],
        'image_codecs': json['image_codecs'],
        'server_time': (json['server_time'] == null ? json['server_time'] : parseDateTime(json['server_time'])),
    };
}

export function ServiceToJSON(json: any): Service {
    return ServiceToJSONTyped(json, false);
}

export function ServiceToJSONTyped(value?: Service | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'name': value['name'],
        'version': value['version'],
        'protocol': ProtocolRangeToJSON(value['protocol']),
        'profiles': value['profiles'],
        'limits': LimitsToJSON(value['limits']),
        'encodings': value['encodings'],
        'image_codecs': value['image_codecs'],
        'server_time': value['server_time'] == null ? value['server_time'] : serializeDateTime(value['server_time']),
    };
}
