/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { CalibrationTask } from './CalibrationTask';
import {
    CalibrationTaskFromJSON,
    CalibrationTaskFromJSONTyped,
    CalibrationTaskToJSON,
    CalibrationTaskToJSONTyped,
} from './CalibrationTask';
import type { SuccessRule } from './SuccessRule';
import {
    SuccessRuleFromJSON,
    SuccessRuleFromJSONTyped,
    SuccessRuleToJSON,
    SuccessRuleToJSONTyped,
} from './SuccessRule';

/**
 * Only for the benchmark `calibration`, which the submitter shapes.
 * @export
 * @interface CalibrationOptions
 */
export interface CalibrationOptions {
    /**
     * One entry per episode, in order; one `score` episode when absent.
     */
    tasks?: Array<CalibrationTask>;
    /**
     * 10 when absent.
     */
    max_steps?: number;
    /**
     *
     */
    success_rule?: SuccessRule;
    /**
     * 3 when absent.
     */
    max_attempts?: number;
    /**
     * 3 when absent.
     */
    max_faults?: number;
    /**
     * Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`.
     */
    sealed?: boolean;
    /**
     * Seconds for which the run stays queued after submit and after resume; 0 when absent.
     */
    queue_s?: number;
}



/**
 * Check if a given object implements the CalibrationOptions interface.
 */
export function instanceOfCalibrationOptions(value: object): value is CalibrationOptions {
    return true;
}

export function CalibrationOptionsFromJSON(json: any): CalibrationOptions {
    return CalibrationOptionsFromJSONTyped(json, false);
}

export function CalibrationOptionsFromJSONTyped(json: any, ignoreDiscriminator: boolean): CalibrationOptions {
    if (json == null) {
        return json;
    }
    checkMembers('CalibrationOptions', json);
    return {

        'tasks': json['tasks'] == null ? undefined : ((json['tasks'] as Array<any>).map(CalibrationTaskFromJSON)),
        'max_steps': json['max_steps'] == null ? undefined : json['max_steps'],
        'success_rule': json['success_rule'] == null ? undefined : SuccessRuleFromJSON(json['success_rule']),
        'max_attempts': json['max_attempts'] == null ? undefined : json['max_attempts'],
        'max_faults': json['max_faults'] == null ? undefined : json['max_faults'],
        'sealed': json['sealed'] == null ? undefined : json['sealed'],
        'queue_s': json['queue_s'] == null ? undefined : json['queue_s'],
    };
}

export function CalibrationOptionsToJSON(json: any): CalibrationOptions {
    return CalibrationOptionsToJSONTyped(json, false);
}

export function CalibrationOptionsToJSONTyped(value?: CalibrationOptions | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

        'tasks': value['tasks'] == null ? undefined : ((value['tasks'] as Array<any>).map(CalibrationTaskToJSON)),
        'max_steps': value['max_steps'],
        'success_rule': SuccessRuleToJSON(value['success_rule']),
        'max_attempts': value['max_attempts'],
        'max_faults': value['max_faults'],
        'sealed': value['sealed'],
        'queue_s': value['queue_s'],
    };
}
