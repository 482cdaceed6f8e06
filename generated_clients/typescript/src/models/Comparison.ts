/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { ComparedRun } from './ComparedRun';
import {
    ComparedRunFromJSON,
    ComparedRunFromJSONTyped,
    ComparedRunToJSON,
    ComparedRunToJSONTyped,
} from './ComparedRun';

/**
 * See scoring.md for every number here.
 * @export
 * @interface Comparison
 */
export interface Comparison {
    [key: string]: any | any;
    /**
     * Id of the run that the others are compared with.
     */
    baseline: string;
    /**
     *
     */
    benchmark_id: string;
    /**
     * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
     */
    manifest_sha256: string;
    /**
     *
     */
    tolerance: number;
    /**
     * One entry per run that was named, in that order.
     */
    runs: Array<ComparedRun>;
}

/**
 * Check if a given object implements the Comparison interface.
 */
export function instanceOfComparison(value: object): value is Comparison {
    if (!('baseline' in value) || value['baseline'] === undefined) return false;
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('tolerance' in value) || value['tolerance'] === undefined) return false;
    if (!('runs' in value) || value['runs'] === undefined) return false;
    return true;
}

export function ComparisonFromJSON(json: any): Comparison {
    return ComparisonFromJSONTyped(json, false);
}

export function ComparisonFromJSONTyped(json: any, ignoreDiscriminator: boolean): Comparison {
    if (json == null) {
        return json;
    }
    checkMembers('Comparison', json);
    return {

            ...json,
        'baseline': json['baseline'],
        'benchmark_id': json['benchmark_id'],
        'manifest_sha256': json['manifest_sha256'],
        'tolerance': json['tolerance'],
        'runs': ((json['runs'] as Array<any>).map(ComparedRunFromJSON)),
    };
}

export function ComparisonToJSON(json: any): Comparison {
    return ComparisonToJSONTyped(json, false);
}

export function ComparisonToJSONTyped(value?: Comparison | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'baseline': value['baseline'],
        'benchmark_id': value['benchmark_id'],
        'manifest_sha256': value['manifest_sha256'],
        'tolerance': value['tolerance'],
        'runs': ((value['runs'] as Array<any>).map(ComparedRunToJSON)),
    };
}
