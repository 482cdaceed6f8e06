/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues, parseDate, parseDateTime, serializeDate, serializeDateTime } from '../runtime';
import { checkMembers } from '../shapes';
import type { RecordReplay } from './RecordReplay';
import {
    RecordReplayFromJSON,
    RecordReplayFromJSONTyped,
    RecordReplayToJSON,
    RecordReplayToJSONTyped,
} from './RecordReplay';
import type { ImportedPolicy } from './ImportedPolicy';
import {
    ImportedPolicyFromJSON,
    ImportedPolicyFromJSONTyped,
    ImportedPolicyToJSON,
    ImportedPolicyToJSONTyped,
} from './ImportedPolicy';

/**
 * A record that was handed in, and what is known of it here.
 * @export
 * @interface RecordImport
 */
export interface RecordImport {
    [key: string]: any | any;
    /**
     *
     */
    import_id: string;
    /**
     * `waiting` for simulators, `replaying`, or `finished`.
     */
    state: string;
    /**
     * `reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise.
     */
    level: string;
    /**
     * The level with who says it, as REC-031 has it.
     */
    level_text: string;
    /**
     * Whose key signed the record, as this server knows it; null for a key that it does not know.
     */
    signer: string | null;
    /**
     * Of the key that signed the record.
     */
    keyid: string;
    /**
     *
     */
    archive_sha256: string;
    /**
     *
     */
    statement_sha256: string;
    /**
     *
     */
    size_bytes: number;
    /**
     * In the statement, as are the members below it.
     */
    run_id: string;
    /**
     *
     */
    benchmark_id: string;
    /**
     *
     */
    benchmark_version: string;
    /**
     *
     */
    manifest_sha256: string;
    /**
     *
     */
    policy: ImportedPolicy;
    /**
     * Null where an episode has no result.
     */
    score: number | null;
    /**
     *
     */
    episodes: number;
    /**
     * How many of them were simulated so far.
     */
    episodes_replayed: number;
    /**
     *
     */
    replay?: RecordReplay;
    /**
     * Why there is no replay.
     */
    reason: string | null;
    /**
     *
     */
    imported_at: Date;
    /**
     *
     */
    finished_at: Date | null;
}

/**
 * Check if a given object implements the RecordImport interface.
 */
export function instanceOfRecordImport(value: object): value is RecordImport {
    if (!('import_id' in value) || value['import_id'] === undefined) return false;
    if (!('state' in value) || value['state'] === undefined) return false;
    if (!('level' in value) || value['level'] === undefined) return false;
    if (!('level_text' in value) || value['level_text'] === undefined) return false;
    if (!('signer' in value) || value['signer'] === undefined) return false;
    if (!('keyid' in value) || value['keyid'] === undefined) return false;
    if (!('archive_sha256' in value) || value['archive_sha256'] === undefined) return false;
    if (!('statement_sha256' in value) || value['statement_sha256'] === undefined) return false;
    if (!('size_bytes' in value) || value['size_bytes'] === undefined) return false;
    if (!('run_id' in value) || value['run_id'] === undefined) return false;
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('benchmark_version' in value) || value['benchmark_version'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('policy' in value) || value['policy'] === undefined) return false;
    if (!('score' in value) || value['score'] === undefined) return false;
    if (!('episodes' in value) || value['episodes'] === undefined) return false;
    if (!('episodes_replayed' in value) || value['episodes_replayed'] === undefined) return false;
    if (!('reason' in value) || value['reason'] === undefined) return false;
    if (!('imported_at' in value) || value['imported_at'] === undefined) return false;
    if (!('finished_at' in value) || value['finished_at'] === undefined) return false;
    return true;
}

export function RecordImportFromJSON(json: any): RecordImport {
    return RecordImportFromJSONTyped(json, false);
}

export function RecordImportFromJSONTyped(json: any, ignoreDiscriminator: boolean): RecordImport {
    if (json == null) {
        return json;
    }
    checkMembers('RecordImport', json);
    return {

            ...json,
        'import_id': json['import_id'],
        'state': json['state'],
        'level': json['level'],
        'level_text': json['level_text'],
        'signer': json['signer'],
        'keyid': json['keyid'],
        'archive_sha256': json['archive_sha256'],
        'statement_sha256': json['statement_sha256'],
        'size_bytes': json['size_bytes'],
        'run_id': json['run_id'],
        'benchmark_id': json['benchmark_id'],
        'benchmark_version': json['benchmark_version'],
        'manifest_sha256': json['manifest_sha256'],
        'policy': ImportedPolicyFromJSON(json['policy']),
        'score': json['score'],
        'episodes': json['episodes'],
        'episodes_replayed': json['episodes_replayed'],
        'replay': json['replay'] == null ? undefined : RecordReplayFromJSON(json['replay']),
        'reason': json['reason'],
        'imported_at': (json['imported_at'] == null ? json['imported_at'] : parseDateTime(json['imported_at'])),
        'finished_at': (json['finished_at'] == null ? null : parseDateTime(json['finished_at'])),
    };
}

export function RecordImportToJSON(json: any): RecordImport {
    return RecordImportToJSONTyped(json, false);
}

export function RecordImportToJSONTyped(value?: RecordImport | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'import_id': value['import_id'],
        'state': value['state'],
        'level': value['level'],
        'level_text': value['level_text'],
        'signer': value['signer'],
        'keyid': value['keyid'],
        'archive_sha256': value['archive_sha256'],
        'statement_sha256': value['statement_sha256'],
        'size_bytes': value['size_bytes'],
        'run_id': value['run_id'],
        'benchmark_id': value['benchmark_id'],
        'benchmark_version': value['benchmark_version'],
        'manifest_sha256': value['manifest_sha256'],
        'policy': ImportedPolicyToJSON(value['policy']),
        'score': value['score'],
        'episodes': value['episodes'],
        'episodes_replayed': value['episodes_replayed'],
        'replay': RecordReplayToJSON(value['replay']),
        'reason': value['reason'],
        'imported_at': value['imported_at'] == null ? value['imported_at'] : serializeDateTime(value['imported_at']),
        'finished_at': value['finished_at'] == null ? value['finished_at'] : serializeDateTime(value['finished_at']),
    };
}
