/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { BenchmarkSummary } from './BenchmarkSummary';
import {
    BenchmarkSummaryFromJSON,
    BenchmarkSummaryFromJSONTyped,
    BenchmarkSummaryToJSON,
    BenchmarkSummaryToJSONTyped,
} from './BenchmarkSummary';

/**
 *
 * @export
 * @interface BenchmarkList
 */
export interface BenchmarkList {
    [key: string]: any | any;
    /**
     *
     */
    benchmarks: Array<BenchmarkSummary>;
}

/**
 * Check if a given object implements the BenchmarkList interface.
 */
export function instanceOfBenchmarkList(value: object): value is BenchmarkList {
    if (!('benchmarks' in value) || value['benchmarks'] === undefined) return false;
    return true;
}

export function BenchmarkListFromJSON(json: any): BenchmarkList {
    return BenchmarkListFromJSONTyped(json, false);
}

export function BenchmarkListFromJSONTyped(json: any, ignoreDiscriminator: boolean): BenchmarkList {
    if (json == null) {
        return json;
    }
    checkMembers('BenchmarkList', json);
    return {

            ...json,
        'benchmarks': ((json['benchmarks'] as Array<any>).map(BenchmarkSummaryFromJSON)),
    };
}

export function BenchmarkListToJSON(json: any): BenchmarkList {
    return BenchmarkListToJSONTyped(json, false);
}

export function BenchmarkListToJSONTyped(value?: BenchmarkList | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'benchmarks': ((value['benchmarks'] as Array<any>).map(BenchmarkSummaryToJSON)),
    };
}
