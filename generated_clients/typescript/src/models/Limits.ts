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
 * @interface Limits
 */
export interface Limits {
    [key: string]: any | any;
    /**
     * Longest request body that is read.
     */
    max_body_bytes: number;
    /**
     * Most live workers a run may ask for.
     */
    max_workers: number;
    /**
     * Most actions in one predict; a benchmark may allow fewer.
     */
    max_chunk: number;
    /**
     *
     */
    idle_timeout_s_min: number;
    /**
     *
     */
    idle_timeout_s_max: number;
    /**
     * Longest wait that a long-poll is granted.
     */
    wait_s_max: number;
    /**
     * Longest request line with its headers that is read; for the profile `limits`.
     */
    max_header_bytes?: number;
    /**
     * Time in which the headers of a request are complete, from its first byte; for the profile `limits`.
     */
    header_timeout_s?: number;
    /**
     * Time in which a part of a body arrives after the headers of its request; for the profile `limits`.
     */
    body_timeout_s?: number;
    /**
     * Longest time that a session lives without a new turn, whatever its `idle_timeout_s`; for the profile `limits`.
     */
    heartbeat_s_max?: number;
    /**
     * When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`.
     */
    unused_s_max?: number;
    /**
     * Longest body that is read of a request other than `predict`, where it is less than `max_body_bytes`; for the profile `limits`.
     */
    max_control_body_bytes?: number;
    /**
     * Most runs of one account that are queued, ready, running or stopping; for the profile `limits`.
     */
    max_open_runs?: number;
    /**
     * Most Idempotency-Keys that one account may use; for the profile `limits`.
     */
    max_idempotency_keys?: number;
    /**
     * Most bytes that the submissions of one account may have together; what else a server stores for a run may count, too. For the profile `limits`.
     */
    max_stored_bytes?: number;
    /**
     * Longest archive that `import_record` reads; for the profile `record_import`.
     */
    max_record_bytes?: number;
    /**
     * Most imports of one account that are not `finished`; for the profile `record_import`.
     */
    max_waiting_imports?: number;
    /**
     * Most bytes that the archives of one account may have together; for the profile `record_import`.
     */
    max_imported_bytes?: number;
    /**
     * Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`.
     */
    run_keep_days?: number;
}

/**
 * Check if a given object implements the Limits interface.
 */
export function instanceOfLimits(value: object): value is Limits {
    if (!('max_body_bytes' in value) || value['max_body_bytes'] === undefined) return false;
    if (!('max_workers' in value) || value['max_workers'] === undefined) return false;
    if (!('max_chunk' in value) || value['max_chunk'] === undefined) return false;
    if (!('idle_timeout_s_min' in value) || value['idle_timeout_s_min'] === undefined) return false;
    if (!('idle_timeout_s_max' in value) || value['idle_timeout_s_max'] === undefined) return false;
    if (!('wait_s_max' in value) || value['wait_s_max'] === undefined) return false;
    return true;
}

export function LimitsFromJSON(json: any): Limits {
    return LimitsFromJSONTyped(json, false);
}

export function LimitsFromJSONTyped(json: any, ignoreDiscriminator: boolean): Limits {
    if (json == null) {
        return json;
    }
    checkMembers('Limits', json);
    return {

            ...json,
        'max_body_bytes': json['max_body_bytes'],
        'max_workers': json['max_workers'],
        'max_chunk': json['max_chunk'],
        'idle_timeout_s_min': json['idle_timeout_s_min'],
        'idle_timeout_s_max': json['idle_timeout_s_max'],
        'wait_s_max': json['wait_s_max'],
        'max_header_bytes': json['max_header_bytes'] == null ? undefined : json['max_header_bytes'],
        'header_timeout_s': json['header_timeout_s'] == null ? undefined : json['header_timeout_s'],
        'body_timeout_s': json['body_timeout_s'] == null ? undefined : json['body_timeout_s'],
        'heartbeat_s_max': json['heartbeat_s_max'] == null ? undefined : json['heartbeat_s_max'],
        'unused_s_max': json['unused_s_max'] == null ? undefined : json['unused_s_max'],
        'max_control_body_bytes': json['max_control_body_bytes'] == null ? undefined : json['max_control_body_bytes'],
        'max_open_runs': json['max_open_runs'] == null ? undefined : json['max_open_runs'],
        'max_idempotency_keys': json['max_idempotency_keys'] == null ? undefined : json['max_idempotency_keys'],
        'max_stored_bytes': json['max_stored_bytes'] == null ? undefined : json['max_stored_bytes'],
        'max_record_bytes': json['max_record_bytes'] == null ? undefined : json['max_record_bytes'],
        'max_waiting_imports': json['max_waiting_imports'] == null ? undefined : json['max_waiting_imports'],
        'max_imported_bytes': json['max_imported_bytes'] == null ? undefined : json['max_imported_bytes'],
        'run_keep_days': json['run_keep_days'] == null ? undefined : json['run_keep_days'],
    };
}

export function LimitsToJSON(json: any): Limits {
    return LimitsToJSONTyped(json, false);
}

export function LimitsToJSONTyped(value?: Limits | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'max_body_bytes': value['max_body_bytes'],
        'max_workers': value['max_workers'],
        'max_chunk': value['max_chunk'],
        'idle_timeout_s_min': value['idle_timeout_s_min'],
        'idle_timeout_s_max': value['idle_timeout_s_max'],
        'wait_s_max': value['wait_s_max'],
        'max_header_bytes': value['max_header_bytes'],
        'header_timeout_s': value['header_timeout_s'],
        'body_timeout_s': value['body_timeout_s'],
        'heartbeat_s_max': value['heartbeat_s_max'],
        'unused_s_max': value['unused_s_max'],
        'max_control_body_bytes': value['max_control_body_bytes'],
        'max_open_runs': value['max_open_runs'],
        'max_idempotency_keys': value['max_idempotency_keys'],
        'max_stored_bytes': value['max_stored_bytes'],
        'max_record_bytes': value['max_record_bytes'],
        'max_waiting_imports': value['max_waiting_imports'],
        'max_imported_bytes': value['max_imported_bytes'],
        'run_keep_days': value['run_keep_days'],
    };
}
