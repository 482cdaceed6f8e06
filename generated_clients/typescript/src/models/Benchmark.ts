/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { ObservationSpace } from './ObservationSpace';
import {
    ObservationSpaceFromJSON,
    ObservationSpaceFromJSONTyped,
    ObservationSpaceToJSON,
    ObservationSpaceToJSONTyped,
} from './ObservationSpace';
import type { ImageSize } from './ImageSize';
import {
    ImageSizeFromJSON,
    ImageSizeFromJSONTyped,
    ImageSizeToJSON,
    ImageSizeToJSONTyped,
} from './ImageSize';
import type { VectorSpace } from './VectorSpace';
import {
    VectorSpaceFromJSON,
    VectorSpaceFromJSONTyped,
    VectorSpaceToJSON,
    VectorSpaceToJSONTyped,
} from './VectorSpace';
import type { SimulatorInfo } from './SimulatorInfo';
import {
    SimulatorInfoFromJSON,
    SimulatorInfoFromJSONTyped,
    SimulatorInfoToJSON,
    SimulatorInfoToJSONTyped,
} from './SimulatorInfo';

/**
 * Everything about a benchmark that can change a score.
 * @export
 * @interface Benchmark
 */
export interface Benchmark {
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
     *
     */
    description: string;
    /**
     * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
     */
    manifest_sha256: string;
    /**
     *
     */
    episodes_total: number;
    /**
     *
     */
    tasks: Array<string>;
    /**
     *
     */
    splits: Array<string>;
    /**
     * Splits whose seeds the host draws in secret; none when absent.
     */
    sealed_splits?: Set<string>;
    /**
     * What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played.
     */
    seeds_sha256?: string;
    /**
     * Actions per simulated second.
     */
    control_rate_hz: number;
    /**
     * Steps after which an episode is truncated.
     */
    max_steps: number;
    /**
     *
     */
    max_chunk: number;
    /**
     *
     */
    max_attempts: number;
    /**
     *
     */
    max_faults: number;
    /**
     * A `SuccessRule`, or one of a later version.
     */
    success_rule: string;
    /**
     * Name of an action value → what it means.
     */
    action_space: { [key: string]: VectorSpace; };
    /**
     *
     */
    observation_space: ObservationSpace;
    /**
     * Sizes that may be chosen at submit; the first is the default.
     */
    image_sizes: Array<ImageSize>;
    /**
     * Codecs that may be chosen at submit; the first is the default.
     */
    image_codecs: Array<string>;
    /**
     *
     */
    simulator: SimulatorInfo;
    /**
     * Why a run cannot be submitted here now, and the cure; null when it can.
     */
    unavailable_reason: string | null;
}

/**
 * Check if a given object implements the Benchmark interface.
 */
export function instanceOfBenchmark(value: object): value is Benchmark {
    if (!('benchmark_id' in value) || value['benchmark_id'] === undefined) return false;
    if (!('version' in value) || value['version'] === undefined) return false;
    if (!('title' in value) || value['title'] === undefined) return false;
    if (!('description' in value) || value['description'] === undefined) return false;
    if (!('manifest_sha256' in value) || value['manifest_sha256'] === undefined) return false;
    if (!('episodes_total' in value) || value['episodes_total'] === undefined) return false;
    if (!('tasks' in value) || value['tasks'] === undefined) return false;
    if (!('splits' in value) || value['splits'] === undefined) return false;
    if (!('control_rate_hz' in value) || value['control_rate_hz'] === undefined) return false;
    if (!('max_steps' in value) || value['max_steps'] === undefined) return false;
    if (!('max_chunk' in value) || value['max_chunk'] === undefined) return false;
    if (!('max_attempts' in value) || value['max_attempts'] === undefined) return false;
    if (!('max_faults' in value) || value['max_faults'] === undefined) return false;
    if (!('success_rule' in value) || value['success_rule'] === undefined) return false;
    if (!('action_space' in value) || value['action_space'] === undefined) return false;
    if (!('observation_space' in value) || value['observation_space'] === undefined) return false;
    if (!('image_sizes' in value) || value['image_sizes'] === undefined) return false;
    if (!('image_codecs' in value) || value['image_codecs'] === undefined) return false;
    if (!('simulator' in value) || value['simulator'] === undefined) return false;
    if (!('unavailable_reason' in value) || value['unavailable_reason'] === undefined) return false;
    return true;
}

export function BenchmarkFromJSON(json: any): Benchmark {
    return BenchmarkFromJSONTyped(json, false);
}

export function BenchmarkFromJSONTyped(json: any, ignoreDiscriminator: boolean): Benchmark {
    if (json == null) {
        return json;
    }
    checkMembers('Benchmark', json);
    return {

            ...json,
        'benchmark_id': json['benchmark_id'],
        'version': json['version'],
        'title': json['title'],
        'description': json['description'],
        'manifest_sha256': json['manifest_sha256'],
        'episodes_total': json['episodes_total'],
        'tasks': json['tasks'],
        'splits': json['splits'],
        'sealed_splits': json['sealed_splits'] == null ? undefined : new Set(json['sealed_splits']),
        'seeds_sha256': json['seeds_sha256'] == null ? undefined : json['seeds_sha256'],
        'control_rate_hz': json['control_rate_hz'],
        'max_steps': json['max_steps'],
        'max_chunk': json['max_chunk'],
        'max_attempts': json['max_attempts'],
        'max_faults': json['max_faults'],
        'success_rule': json['success_rule'],
        'action_space': (mapValues(json['action_space'], VectorSpaceFromJSON)),
        'observation_space': ObservationSpaceFromJSON(json['observation_space']),
        'image_sizes': ((json['image_sizes'] as Array<any>).map(ImageSizeFromJSON)),
        'image_codecs': json['image_codecs'],
        'simulator': SimulatorInfoFromJSON(json['simulator']),
        'unavailable_reason': json['unavailable_reason'],
    };
}

export function BenchmarkToJSON(json: any): Benchmark {
    return BenchmarkToJSONTyped(json, false);
}

export function BenchmarkToJSONTyped(value?: Benchmark | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'benchmark_id': value['benchmark_id'],
        'version': value['version'],
        'title': value['title'],
        'description': value['description'],
        'manifest_sha256': value['manifest_sha256'],
        'episodes_total': value['episodes_total'],
        'tasks': value['tasks'],
        'splits': value['splits'],
        'sealed_splits': value['sealed_splits'] == null ? undefined : Array.from(value['sealed_splits'] as Set<any>),
        'seeds_sha256': value['seeds_sha256'],
        'control_rate_hz': value['control_rate_hz'],
        'max_steps': value['max_steps'],
        'max_chunk': value['max_chunk'],
        'max_attempts': value['max_attempts'],
        'max_faults': value['max_faults'],
        'success_rule': value['success_rule'],
        'action_space': (mapValues(value['action_space'], VectorSpaceToJSON)),
        'observation_space': ObservationSpaceToJSON(value['observation_space']),
        'image_sizes': ((value['image_sizes'] as Array<any>).map(ImageSizeToJSON)),
        'image_codecs': value['image_codecs'],
        'simulator': SimulatorInfoToJSON(value['simulator']),
        'unavailable_reason': value['unavailable_reason'],
    };
}
