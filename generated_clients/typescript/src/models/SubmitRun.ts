/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { EpisodeSelection } from './EpisodeSelection';
import {
    EpisodeSelectionFromJSON,
    EpisodeSelectionFromJSONTyped,
    EpisodeSelectionToJSON,
    EpisodeSelectionToJSONTyped,
} from './EpisodeSelection';
import type { PolicyServer } from './PolicyServer';
import {
    PolicyServerFromJSON,
    PolicyServerFromJSONTyped,
    PolicyServerToJSON,
    PolicyServerToJSONTyped,
} from './PolicyServer';
import type { CalibrationOptions } from './CalibrationOptions';
import {
    CalibrationOptionsFromJSON,
    CalibrationOptionsFromJSONTyped,
    CalibrationOptionsToJSON,
    CalibrationOptionsToJSONTyped,
} from './CalibrationOptions';
import type { ImageChoice } from './ImageChoice';
import {
    ImageChoiceFromJSON,
    ImageChoiceFromJSONTyped,
    ImageChoiceToJSON,
    ImageChoiceToJSONTyped,
} from './ImageChoice';
import type { RunMode } from './RunMode';
import {
    RunModeFromJSON,
    RunModeFromJSONTyped,
    RunModeToJSON,
    RunModeToJSONTyped,
} from './RunMode';
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
 * @interface SubmitRun
 */
export interface SubmitRun {
    /**
     *
     */
    benchmark_id: string;
    /**
     *
     */
    policy: PolicyInfo;
    /**
     * Most live workers wanted; the server's limit when absent.
     */
    max_workers?: number;
    /**
     * Lease of a session; the server's maximum when absent.
     */
    idle_timeout_s?: number;
    /**
     *
     */
    images?: ImageChoice;
    /**
     *
     */
    options?: CalibrationOptions;
    /**
     *
     */
    mode?: RunMode;
    /**
     *
     */
    policy_server?: PolicyServer;
    /**
     * Workers may play for another policy than `policy`; false when absent; for the profile `attribution`.
     */
    any_policy?: boolean;
    /**
     *
     */
    select?: EpisodeSelection;
}



/**
 * Check if a given object implements the SubmitRun interface.
 */
export function instanceOfSubmitRun(value: object): value is SubmitRun {
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('policy' in value) || value['policy'] === undefined) return false;
    return true;
}

export function SubmitRunFromJSON(json: any): SubmitRun {
    return SubmitRunFromJSONTyped(json, false);
}

export function SubmitRunFromJSONTyped(json: any, ignoreDiscriminator: boolean): SubmitRun {
    if (json == null) {
        return json;
    }
    checkMembers('SubmitRun', json);
    return {

        'benchmark_id': json['benchmark_id'],
        'policy': PolicyInfoFromJSON(json['policy']),
        'max_workers': json['max_workers'] == null ? undefined : json['max_workers'],
        'idle_timeout_s': json['idle_timeout_s'] == null ? undefined : json['idle_timeout_s'],
        'images': json['images'] == null ? undefined : ImageChoiceFromJSON(json['images']),
        'options': json['options'] == null ? undefined : CalibrationOptionsFromJSON(json['options']),
        'mode': json['mode'] == null ? undefined : RunModeFromJSON(json['mode']),
        'policy_server': json['policy_server'] == null ? undefined : PolicyServerFromJSON(json['policy_server']),
        'any_policy': json['any_policy'] == null ? undefined : json['any_policy'],
        'select': json['select'] == null ? undefined : EpisodeSelectionFromJSON(json['select']),
    };
}

export function SubmitRunToJSON(json: any): SubmitRun {
    return SubmitRunToJSONTyped(json, false);
}

export function SubmitRunToJSONTyped(value?: SubmitRun | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'benchmark_id': value['benchmark_id'],
        'policy': PolicyInfoToJSON(value['policy']),
        'max_workers': value['max_workers'],
        'idle_timeout_s': value['idle_timeout_s'],
        'images': ImageChoiceToJSON(value['images']),
        'options': CalibrationOptionsToJSON(value['options']),
        'mode': RunModeToJSON(value['mode']),
        'policy_server': PolicyServerToJSON(value['policy_server']),
        'any_policy': value['any_policy'],
        'select': EpisodeSelectionToJSON(value['select']),
    };
}
