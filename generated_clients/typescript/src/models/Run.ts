/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues, parseDate, parseDateTime, serializeDate, serializeDateTime } from '../runtime';
import { checkMembers } from '../shapes';
import type { RunState } from './RunState';
import {
    RunStateFromJSON,
    RunStateFromJSONTyped,
    RunStateToJSON,
    RunStateToJSONTyped,
} from './RunState';
import type { Progress } from './Progress';
import {
    ProgressFromJSON,
    ProgressFromJSONTyped,
    ProgressToJSON,
    ProgressToJSONTyped,
} from './Progress';
import type { PolicyServerView } from './PolicyServerView';
import {
    PolicyServerViewFromJSON,
    PolicyServerViewFromJSONTyped,
    PolicyServerViewToJSON,
    PolicyServerViewToJSONTyped,
} from './PolicyServerView';
import type { SelectionView } from './SelectionView';
import {
    SelectionViewFromJSON,
    SelectionViewFromJSONTyped,
    SelectionViewToJSON,
    SelectionViewToJSONTyped,
} from './SelectionView';
import type { ImageChoice } from './ImageChoice';
import {
    ImageChoiceFromJSON,
    ImageChoiceFromJSONTyped,
    ImageChoiceToJSON,
    ImageChoiceToJSONTyped,
} from './ImageChoice';
import type { PolicyInfo } from './PolicyInfo';
import {
    PolicyInfoFromJSON,
    PolicyInfoFromJSONTyped,
    PolicyInfoToJSON,
    PolicyInfoToJSONTyped,
} from './PolicyInfo';

/**
 *
 * @export
 * @interface Run
 */
export interface Run {
    [key: string]: any | any;
    /**
     *
     */
    run_id: string;
    /**
     *
     */
    state: RunState;
    /**
     * Why the run is in this state, for people; never null when failed.
     */
    reason: string | null;
    /**
     * Whether a failed run may be resumed; null in other states.
     */
    retryable: boolean | null;
    /**
     *
     */
    benchmark_id: string;
    /**
     *
     */
    benchmark_version: string;
    /**
     * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
     */
    manifest_sha256: string;
    /**
     *
     */
    policy: PolicyInfo;
    /**
     * A `RunMode`, or one of a later version; `pull` when absent.
     */
    mode?: string;
    /**
     *
     */
    policy_server?: PolicyServerView;
    /**
     * Whether workers may play for another policy than `policy`; for the profile `attribution`.
     */
    any_policy?: boolean;
    /**
     *
     */
    select?: SelectionView;
    /**
     *
     */
    max_workers: number;
    /**
     *
     */
    idle_timeout_s: number;
    /**
     *
     */
    images: ImageChoice;
    /**
     * Base URL of the data plane for this run; the path of an operation is appended to it.
     */
    endpoint: string;
    /**
     * 1 is next; null unless queued.
     */
    queue_position: number | null;
    /**
     *
     */
    live_workers: number;
    /**
     *
     */
    progress: Progress;
    /**
     *
     */
    created_at: Date;
    /**
     *
     */
    updated_at: Date;
    /**
     * In how many runs of this benchmark its submitter had executed an action before the first one of this run, whether they were deleted or not; absent before that action. For the profile `deletion`.
     */
    runs_played_before?: number;
    /**
     * How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`.
     */
    attempts_by_submitter?: number;
}



/**
 * Check if a given object implements the Run interface.
 */
export function instanceOfRun(value: object): value is Run {
    if (!('run_id' in value) || value['run_id'] === undefined) return false;
    if (!('state' in value) || value['state'] === undefined) return false;
    if (!('reason' in value) || value['reason'] === undefined) return false;
    if (!('retryable' in value) || value['retryable'] === undefined) return false;
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('benchmark_version' in value) || value['benchmark_version'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('policy' in value) || value['policy'] === undefined) return false;
    if (!('max_workers' in value) || value['max_workers'] === undefined) return false;
    if (!('idle_timeout_s' in value) || value['idle_timeout_s'] === undefined) return false;
    if (!('images' in value) || value['images'] === undefined) return false;
    if (!('endpoint' in value) || value['endpoint'] === undefined) return false;
    if (!('queue_position' in value) || value['queue_position'] === undefined) return false;
    if (!('live_workers' in value) || value['live_workers'] === undefined) return false;
    if (!('progress' in value) || value['progress'] === undefined) return false;
    if (!('created_at' in value) || value['created_at'] === undefined) return false;
    if (!('updated_at' in value) || value['updated_at'] === undefined) return false;
    return true;
}

export function RunFromJSON(json: any): Run {
    return RunFromJSONTyped(json, false);
}

export function RunFromJSONTyped(json: any, ignoreDiscriminator: boolean): Run {
    if (json == null) {
        return json;
    }
    checkMembers('Run', json);
    return {

            ...json,
        'run_id': json['run_id'],
        'state': RunStateFromJSON(json['state']),
        'reason': json['reason'],
        'retryable': json['retryable'],
        'benchmark_id': json['benchmark_id'],
        'benchmark_version': json['benchmark_version'],
        'manifest_sha256': json['manifest_sha256'],
        'policy': PolicyInfoFromJSON(json['policy']),
        'mode': json['mode'] == null ? undefined : json['mode'],
        'policy_server': json['policy_server'] == null ? undefined : PolicyServerViewFromJSON(json['policy_server']),
        'any_policy': json['any_policy'] == null ? undefined : json['any_policy'],
        'select': json['select'] == null ? undefined : SelectionViewFromJSON(json['select']),
        'max_workers': json['max_workers'],
        'idle_timeout_s': json['idle_timeout_s'],
        'images': ImageChoiceFromJSON(json['images']),
        'endpoint': json['endpoint'],
        'queue_position': json['queue_position'],
        'live_workers': json['live_workers'],
        'progress': ProgressFromJSON(json['progress']),
        'created_at': (json['created_at'] == null ? json['created_at'] : parseDateTime(json['created_at'])),
        'updated_at': (json['updated_at'] == null ? json['updated_at'] : parseDateTime(json['updated_at'])),
        'runs_played_before': json['runs_played_before'] == null ? undefined : json['runs_played_before'],
        'attempts_by_submitter': json['attempts_by_submitter'] == null ? undefined : json['attempts_by_submitter'],
    };
}

export function RunToJSON(json: any): Run {
    return RunToJSONTyped(json, false);
}

export function RunToJSONTyped(value?: Run | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'run_id': value['run_id'],
        'state': RunStateToJSON(value['state']),
        'reason': value['reason'],
        'retryable': value['retryable'],
        'benchmark_id': value['benchmark_id'],
        'benchmark_version': value['benchmark_version'],
        'manifest_sha256': value['manifest_sha256'],
        'policy': PolicyInfoToJSON(value['policy']),
        'mode': value['mode'],
        'policy_server': PolicyServerViewToJSON(value['policy_server']),
        'any_policy': value['any_policy'],
        'select': SelectionViewToJSON(value['select']),
        'max_workers': value['max_workers'],
        'idle_timeout_s': value['idle_timeout_s'],
        'images': ImageChoiceToJSON(value['images']),
        'endpoint': value['endpoint'],
        'queue_position': value['queue_position'],
        'live_workers': value['live_workers'],
        'progress': ProgressToJSON(value['progress']),
        'created_at': value['created_at'] == null ? value['created_at'] : serializeDateTime(value['created_at']),
        'updated_at': value['updated_at'] == null ? value['updated_at'] : serializeDateTime(value['updated_at']),
        'runs_played_before': value['runs_played_before'],
        'attempts_by_submitter': value['attempts_by_submitter'],
    };
}
