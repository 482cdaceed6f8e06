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
 * @interface BenchmarkSummary
 */
export interface BenchmarkSummary {
    [key: string]: any | any;
    /**
     *
     */
    benchmark_id: string;
    /**
     *
     */
    version: string;
    /**
     *
     */
    title: string;
    /**
     * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
     */
    manifest_sha256: string;
    /**
     *
     */
    episodes_total: number;
}

/**
 * Check if a given object implements the BenchmarkSummary interface.
 */
export function instanceOfBenchmarkSummary(value: object): value is BenchmarkSummary {
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('version' in value) || value['version'] === undefined) return false;
    if (!('title' in value) || value['title'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('episodes_total' in value) || value['episodes_total'] === undefined) return false;
    return true;
}

export function BenchmarkSummaryFromJSON(json: any): BenchmarkSummary {
    return BenchmarkSummaryFromJSONTyped(json, false);
}

export function BenchmarkSummaryFromJSONTyped(json: any, ignoreDiscriminator: boolean): BenchmarkSummary {
    if (json == null) {
        return json;
    }
    checkMembers('BenchmarkSummary', json);
    return {

            ...json,
        'benchmark_id': json['benchmark_id'],
        'version': json['version'],
        'title': json['title'],
        'manifest_sha256': json['manifest_sha256'],
        'episodes_total': json['episodes_total'],
    };
}

export function BenchmarkSummaryToJSON(json: any): BenchmarkSummary {
    return BenchmarkSummaryToJSONTyped(json, false);
}

export function BenchmarkSummaryToJSONTyped(value?: BenchmarkSummary | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'benchmark_id': value['benchmark_id'],
        'version': value['version'],
        'title': value['title'],
        'manifest_sha256': value['manifest_sha256'],
        'episodes_total': value['episodes_total'],
    };
}
