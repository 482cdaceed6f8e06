/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import { BaseApi, type Answer } from '../runtime';
import type {
    AttachWorker,
    Heartbeat,
    Lease,
    Predict,
    Turn,
} from '../models';

export interface AttachWorkerRequest {
    runId: string;
    /** Chosen by the client; stable over re-attachments. */
    workerId: string;
    attachWorker: AttachWorker;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface DetachWorkerRequest {
    runId: string;
    /** Chosen by the client; stable over re-attachments. */
    workerId: string;
    /** The session to close. */
    sessionId: string;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface HeartbeatRequest {
    runId: string;
    /** Chosen by the client; stable over re-attachments. */
    workerId: string;
    heartbeat: Heartbeat;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

export interface PredictRequest {
    runId: string;
    /** Chosen by the client; stable over re-attachments. */
    workerId: string;
    predict: Predict;
    /** The protocol version the caller was written for. */
    proctorVersion?: string;
}

/**
 * Each call throws ResponseError for a refusal, FetchError if no answer comes, InvalidAnswer for a success that is not
 * the message expected. `init` is added to what `fetch` is given: a signal, further headers.
 */
export class DataApi extends BaseApi {
    /** Attach a worker. */
    attachWorker(request: AttachWorkerRequest, init?: RequestInit): Answer<Turn> {
        return this.call('Turn', 'PUT', '/v1/runs/{run_id}/workers/{worker_id}', {
            path: { run_id: request.runId, worker_id: request.workerId },
            headers: { 'Proctor-Version': request.proctorVersion },
            body: request.attachWorker,
        }, init);
    }

    /** Detach a worker. */
    detachWorker(request: DetachWorkerRequest, init?: RequestInit): Answer<void> {
        return this.call(null, 'DELETE', '/v1/runs/{run_id}/workers/{worker_id}', {
            path: { run_id: request.runId, worker_id: request.workerId },
            query: { session_id: request.sessionId },
            headers: { 'Proctor-Version': request.proctorVersion },
        }, init);
    }

    /** Keep a session alive. */
    heartbeat(request: HeartbeatRequest, init?: RequestInit): Answer<Lease> {
        return this.call('Lease', 'POST', '/v1/runs/{run_id}/workers/{worker_id}/heartbeat', {
            path: { run_id: request.runId, worker_id: request.workerId },
            headers: { 'Proctor-Version': request.proctorVersion },
            body: request.heartbeat,
        }, init);
    }

    /** Play a turn. */
    predict(request: PredictRequest, init?: RequestInit): Answer<Turn> {
        return this.call('Turn', 'POST', '/v1/runs/{run_id}/workers/{worker_id}/predict', {
            path: { run_id: request.runId, worker_id: request.workerId },
            headers: { 'Proctor-Version': request.proctorVersion },
            body: request.predict,
        }, init);
    }
}
