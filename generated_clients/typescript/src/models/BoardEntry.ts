/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues, parseDate, parseDateTime, serializeDate, serializeDateTime } from '../runtime';
import { checkMembers } from '../shapes';
import type { SelectionView } from './SelectionView';
import {
    SelectionViewFromJSON,
    SelectionViewFromJSONTyped,
    SelectionViewToJSON,
    SelectionViewToJSONTyped,
} from './SelectionView';
import type { EntryFlag } from './EntryFlag';
import {
    EntryFlagFromJSON,
    EntryFlagFromJSONTyped,
    EntryFlagToJSON,
    EntryFlagToJSONTyped,
} from './EntryFlag';
import type { PolicyInfo } from './PolicyInfo';
import {
    PolicyInfoFromJSON,
    PolicyInfoFromJSONTyped,
    PolicyInfoToJSON,
    PolicyInfoToJSONTyped,
} from './PolicyInfo';
import type { EntryScore } from './EntryScore';
import {
    EntryScoreFromJSON,
    EntryScoreFromJSONTyped,
    EntryScoreToJSON,
    EntryScoreToJSONTyped,
} from './EntryScore';

/**
 *
 * @export
 * @interface BoardEntry
 */
export interface BoardEntry {
    [key: string]: any | any;
    /**
     *
     */
    entry_id: string;
    /**
     *
     */
    run_id: string;
    /**
     * Name of the account that submitted the run.
     */
    submitter: string;
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
    select?: SelectionView;
    /**
     *
     */
    policy: PolicyInfo;
    /**
     *
     */
    model_name: string;
    /**
     *
     */
    is_public: boolean;
    /**
     *
     */
    model_type?: string;
    /**
     *
     */
    organisation?: string;
    /**
     *
     */
    homepage?: string;
    /**
     *
     */
    code_url?: string;
    /**
     *
     */
    notes?: string;
    /**
     *
     */
    state: string;
    /**
     *
     */
    flag?: EntryFlag;
    /**
     * What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs.
     */
    level: string;
    /**
     * How many runs of the benchmark the account has submitted until now, published or not.
     */
    attempts: number;
    /**
     *
     */
    score: EntryScore;
    /**
     *
     */
    published_at: Date;
    /**
     * When the description, the state or the flag changed for the last time.
     */
    changed_at: Date;
}

/**
 * Check if a given object implements the BoardEntry interface.
 */
export function instanceOfBoardEntry(value: object): value is BoardEntry {
    if (!('entry_id' in value) || value['entry_id'] === undefined) return false;
    if (!('run_id' in value) || value['run_id'] === undefined) return false;
    if (!('submitter' in value) || value['submitter'] === undefined) return false;
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('benchmark_version' in value) || value['benchmark_version'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('policy' in value) || value['policy'] === undefined) return false;
    if (!('model_name' in value) || value['model_name'] === undefined) return false;
    if (!('is_public' in value) || value['is_public'] === undefined) return false;
    if (!('state' in value) || value['state'] === undefined) return false;
    if (!('level' in value) || value['level'] === undefined) return false;
    if (!('attempts' in value) || value['attempts'] === undefined) return false;
    if (!('score' in value) || value['score'] === undefined) return false;
    if (!('published_at' in value) || value['published_at'] === undefined) return false;
    if (!('changed_at' in value) || value['changed_at'] === undefined) return false;
    return true;
}

export function BoardEntryFromJSON(json: any): BoardEntry {
    return BoardEntryFromJSONTyped(json, false);
}

export function BoardEntryFromJSONTyped(json: any, ignoreDiscriminator: boolean): BoardEntry {
    if (json == null) {
        return json;
    }
    checkMembers('BoardEntry', json);
    return {

            ...json,
        'entry_id': json['entry_id'],
        'run_id': json['run_id'],
        'submitter': json['submitter'],
        'benchmark_id': json['benchmark_id'],
        'benchmark_version': json['benchmark_version'],
        'manifest_sha256': json['manifest_sha256'],
        'select': json['select'] == null ? undefined : SelectionViewFromJSON(json['select']),
        'policy': PolicyInfoFromJSON(json['policy']),
        'model_name': json['model_name'],
        'is_public': json['is_public'],
        'model_type': json['model_type'] == null ? undefined : json['model_type'],
        'organisation': json['organisation'] == null ? undefined : json['organisation'],
        'homepage': json['homepage'] == null ? undefined : json['homepage'],
        'code_url': json['code_url'] == null ? undefined : json['code_url'],
        'notes': json['notes'] == null ? undefined : json['notes'],
        'state': json['state'],
        'flag': json['flag'] == null ? undefined : EntryFlagFromJSON(json['flag']),
        'level': json['level'],
        'attempts': json['attempts'],
        'score': EntryScoreFromJSON(json['score']),
        'published_at': (json['published_at'] == null ? json['published_at'] : parseDateTime(json['published_at'])),
        'changed_at': (json['changed_at'] == null ? json['changed_at'] : parseDateTime(json['changed_at'])),
    };
}

export function BoardEntryToJSON(json: any): BoardEntry {
    return BoardEntryToJSONTyped(json, false);
}

export function BoardEntryToJSONTyped(value?: BoardEntry | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'entry_id': value['entry_id'],
        'run_id': value['run_id'],
        'submitter': value['submitter'],
        'benchmark_id': value['benchmark_id'],
        'benchmark_version': value['benchmark_version'],
        'manifest_sha256': value['manifest_sha256'],
        'select': SelectionViewToJSON(value['select']),
        'policy': PolicyInfoToJSON(value['policy']),
        'model_name': value['model_name'],
        'is_public': value['is_public'],
        'model_type': value['model_type'],
        'organisation': value['organisation'],
        'homepage': value['homepage'],
        'code_url': value['code_url'],
        'notes': value['notes'],
        'state': value['state'],
        'flag': EntryFlagToJSON(value['flag']),
        'level': value['level'],
        'attempts': value['attempts'],
        'score': EntryScoreToJSON(value['score']),
        'published_at': value['published_at'] == null ? value['published_at'] : serializeDateTime(value['published_at']),
        'changed_at': value['changed_at'] == null ? value['changed_at'] : serializeDateTime(value['changed_at']),
    };
}
