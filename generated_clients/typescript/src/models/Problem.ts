/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { RunState } from './RunState';
import {
    RunStateFromJSON,
    RunStateFromJSONTyped,
    RunStateToJSON,
    RunStateToJSONTyped,
} from './RunState';
import type { ProblemItem } from './ProblemItem';
import {
    ProblemItemFromJSON,
    ProblemItemFromJSONTyped,
    ProblemItemToJSON,
    ProblemItemToJSONTyped,
} from './ProblemItem';
import type { SideEffects } from './SideEffects';
import {
    SideEffectsFromJSON,
    SideEffectsFromJSONTyped,
    SideEffectsToJSON,
    SideEffectsToJSONTyped,
} from './SideEffects';

/**
 * RFC 9457, with what a client needs to decide on a retry.
 * @export
 * @interface Problem
 */
export interface Problem {
    [key: string]: any | any;
    /**
     *
     */
    type: string;
    /**
     *
     */
    title: string;
    /**
     *
     */
    status: number;
    /**
     * What happened and what to do about it.
     */
    detail: string;
    /**
     * One of x-problems, or one of a later version.
     */
    code: string;
    /**
     * Whether the same request can succeed later.
     */
    retryable: boolean;
    /**
     *
     */
    side_effects: SideEffects;
    /**
     *
     */
    errors?: Array<ProblemItem>;
    /**
     * Id of the rule that was enforced.
     */
    requirement?: string;
    /**
     *
     */
    state?: RunState;
    /**
     *
     */
    expected_seq?: number;
    /**
     * What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
     */
    ended_by?: string;
}



/**
 * Check if a given object implements the Problem interface.
 */
export function instanceOfProblem(value: object): value is Problem {
    if (!('type' in value) || value['type'] === undefined) return false;
    if (!('title' in value) || value['title'] === undefined) return false;
    if (!('status' in value) || value['status'] === undefined) return false;
    if (!('detail' in value) || value['detail'] === undefined) return false;
    if (!('code' in value) || value['code'] === undefined) return false;
    if (!('retryable' in value) || value['retryable'] === undefined) return false;
    if (!('side_effects' in value) || value['side_effects'] === undefined) return false;
    return true;
}

export function ProblemFromJSON(json: any): Problem {
    return ProblemFromJSONTyped(json, false);
}

export function ProblemFromJSONTyped(json: any, ignoreDiscriminator: boolean): Problem {
    if (json == null) {
        return json;
    }
    checkMembers('Problem', json);
    return {

            ...json,
        'type': json['type'],
        'title': json['title'],
        'status': json['status'],
        'detail': json['detail'],
        'code': json['code'],
        'retryable': json['retryable'],
        'side_effects': SideEffectsFromJSON(json['side_effects']),
        'errors': json['errors'] == null ? undefined : ((json['errors'] as Array<any>).map(ProblemItemFromJSON)),
        'requirement': json['requirement'] == null ? undefined : json['requirement'],
        'state': json['state'] == null ? undefined : RunStateFromJSON(json['state']),
        'expected_seq': json['expected_seq'] == null ? undefined : json['expected_seq'],
        'ended_by': json['ended_by'] == null ? undefined : json['ended_by'],
    };
}

export function ProblemToJSON(json: any): Problem {
    return ProblemToJSONTyped(json, false);
}

export function ProblemToJSONTyped(value?: Problem | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'type': value['type'],
        'title': value['title'],
        'status': value['status'],
        'detail': value['detail'],
        'code': value['code'],
        'retryable': value['retryable'],
        'side_effects': SideEffectsToJSON(value['side_effects']),
        'errors': value['errors'] == null ? undefined : ((value['errors'] as Array<any>).map(ProblemItemToJSON)),
        'requirement': value['requirement'],
        'state': RunStateToJSON(value['state']),
        'expected_seq': value['expected_seq'],
        'ended_by': value['ended_by'],
    };
}
