/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { mapValues } from '../runtime';
import { checkMembers } from '../shapes';
import type { Lease } from './Lease';
import {
    LeaseFromJSON,
    LeaseFromJSONTyped,
    LeaseToJSON,
    LeaseToJSONTyped,
} from './Lease';
import type { EpisodeResult } from './EpisodeResult';
import {
    EpisodeResultFromJSON,
    EpisodeResultFromJSONTyped,
    EpisodeResultToJSON,
    EpisodeResultToJSONTyped,
} from './EpisodeResult';
import type { Observation } from './Observation';
import {
    ObservationFromJSON,
    ObservationFromJSONTyped,
    ObservationToJSON,
    ObservationToJSONTyped,
} from './Observation';
import type { Fault } from './Fault';
import {
    FaultFromJSON,
    FaultFromJSONTyped,
    FaultToJSON,
    FaultToJSONTyped,
} from './Fault';
import type { Timing } from './Timing';
import {
    TimingFromJSON,
    TimingFromJSONTyped,
    TimingToJSON,
    TimingToJSONTyped,
} from './Timing';
import type { EpisodeView } from './EpisodeView';
import {
    EpisodeViewFromJSON,
    EpisodeViewFromJSONTyped,
    EpisodeViewToJSON,
    EpisodeViewToJSONTyped,
} from './EpisodeView';

/**
 * The answer to attach (seq 0) and to predict.
 * @export
 * @interface Turn
 */
export interface Turn {
    [key: string]: any | any;
    /**
     *
     */
    session_id: string;
    /**
     *
     */
    seq: number;
    /**
     *
     */
    episode?: EpisodeView;
    /**
     *
     */
    observation?: Observation;
    /**
     * With `observe` all, one per executed action.
     */
    observations?: Array<Observation>;
    /**
     *
     */
    executed_steps: number;
    /**
     * The episode ended before the chunk did.
     */
    stopped_early: boolean;
    /**
     * One per executed action.
     */
    rewards: Array<number>;
    /**
     * The task ended by itself in this turn.
     */
    terminated: boolean;
    /**
     * The step limit ended the episode in this turn.
     */
    truncated: boolean;
    /**
     *
     */
    episode_result?: EpisodeResult;
    /**
     *
     */
    fault?: Fault;
    /**
     * No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
     */
    done: boolean;
    /**
     *
     */
    lease: Lease;
    /**
     *
     */
    timing: Timing;
}

/**
 * Check if a given object implements the Turn interface.
 */
export function instanceOfTurn(value: object): value is Turn {
    if (!('session_id' in value) || value['session_id'] === undefined) return false;
    if (!('seq' in value) || value['seq'] === undefined) return false;
    if (!('executed_steps' in value) || value['executed_steps'] === undefined) return false;
    if (!('stopped_early' in value) || value['stopped_early'] === undefined) return false;
    if (!('rewards' in value) || value['rewards'] === undefined) return false;
    if (!('terminated' in value) || value['terminated'] === undefined) return false;
    if (!('truncated' in value) || value['truncated'] === undefined) return false;
    if (!('done' in value) || value['done'] === undefined) return false;
    if (!('lease' in value) || value['lease'] === undefined) return false;
    if (!('timing' in value) || value['timing'] === undefined) return false;
    return true;
}

export function TurnFromJSON(json: any): Turn {
    return TurnFromJSONTyped(json, false);
}

export function TurnFromJSONTyped(json: any, ignoreDiscriminator: boolean): Turn {
    if (json == null) {
        return json;
    }
    checkMembers('Turn', json);
    return {

            ...json,
        'session_id': json['session_id'],
        'seq': json['seq'],
        'episode': json['episode'] == null ? undefined : EpisodeViewFromJSON(json['episode']),
        'observation': json['observation'] == null ? undefined : ObservationFromJSON(json['observation']),
        'observations': json['observations'] == null ? undefined : ((json['observations'] as Array<any>).map(ObservationFromJSON)),
        'executed_steps': json['executed_steps'],
        'stopped_early': json['stopped_early'],
        'rewards': json['rewards'],
        'terminated': json['terminated'],
        'truncated': json['truncated'],
        'episode_result': json['episode_result'] == null ? undefined : EpisodeResultFromJSON(json['episode_result']),
        'fault': json['fault'] == null ? undefined : FaultFromJSON(json['fault']),
        'done': json['done'],
        'lease': LeaseFromJSON(json['lease']),
        'timing': TimingFromJSON(json['timing']),
    };
}

export function TurnToJSON(json: any): Turn {
    return TurnToJSONTyped(json, false);
}

export function TurnToJSONTyped(value?: Turn | null, ignoreDiscriminator: boolean = false): any {
    if (value == null) {
        return value;
    }

    return {

            ...value,
        'session_id': value['session_id'],
        'seq': value['seq'],
        'episode': EpisodeViewToJSON(value['episode']),
        'observation': ObservationToJSON(value['observation']),
        'observations': value['observations'] == null ? undefined : ((value['observations'] as Array<any>).map(ObservationToJSON)),
        'executed_steps': value['executed_steps'],
        'stopped_early': value['stopped_early'],
        'rewards': value['rewards'],
        'terminated': value['terminated'],
        'truncated': value['truncated'],
        'episode_result': EpisodeResultToJSON(value['episode_result']),
        'fault': FaultToJSON(value['fault']),
        'done': value['done'],
        'lease': LeaseToJSON(value['lease']),
        'timing': TimingToJSON(value['timing']),
    };
}
