/* tslint:disable */
/* eslint-disable */
/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

import * as runtime from '../runtime';
import {
    type AttachWorker,
    AttachWorkerFromJSON,
    AttachWorkerToJSON,
} from '../models/AttachWorker';
import {
    type Heartbeat,
    HeartbeatFromJSON,
    HeartbeatToJSON,
} from '../models/Heartbeat';
import {
    type Lease,
    LeaseFromJSON,
    LeaseToJSON,
} from '../models/Lease';
import {
    type Predict,
    PredictFromJSON,
    PredictToJSON,
} from '../models/Predict';
import {
    type Problem,
    ProblemFromJSON,
    ProblemToJSON,
} from '../models/Problem';
import {
    type Turn,
    TurnFromJSON,
    TurnToJSON,
} from '../models/Turn';

export interface AttachWorkerRequest {
    /**
     *
     */
    runId: string;
    /**
     * Chosen by the client; stable over re-attachments.
     */
    workerId: string;
    /**
     *
     */
    attachWorker: AttachWorker;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface DetachWorkerRequest {
    /**
     *
     */
    runId: string;
    /**
     * Chosen by the client; stable over re-attachments.
     */
    workerId: string;
    /**
     * The session to close.
     */
    sessionId: string;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface HeartbeatRequest {
    /**
     *
     */
    runId: string;
    /**
     * Chosen by the client; stable over re-attachments.
     */
    workerId: string;
    /**
     *
     */
    heartbeat: Heartbeat;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

export interface PredictRequest {
    /**
     *
     */
    runId: string;
    /**
     * Chosen by the client; stable over re-attachments.
     */
    workerId: string;
    /**
     *
     */
    predict: Predict;
    /**
     * The protocol version the caller was written for.
     */
    proctorVersion?: string;
}

/**
 *
 */
export class DataApi extends runtime.BaseAPI {

    /**
     * Creates request options for attachWorker without sending the request
     */
    async attachWorkerRequestOpts(requestParameters: AttachWorkerRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling attachWorker().'
            );
        }

        if (requestParameters['workerId'] == null) {
            throw new runtime.RequiredError(
                'workerId',
                'Required parameter "workerId" was null or undefined when calling attachWorker().'
            );
        }

        if (requestParameters['attachWorker'] == null) {
            throw new runtime.RequiredError(
                'attachWorker',
                'Required parameter "attachWorker" was null or undefined when calling attachWorker().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/json';

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/workers/{worker_id}`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));
        urlPath = urlPath.replace('{worker_id}', encodeURIComponent(String(requestParameters['workerId'])));

        return {
            path: urlPath,
            method: 'PUT',
            headers: headerParameters,
            query: queryParameters,
            body: AttachWorkerToJSON(requestParameters['attachWorker']),
        };
    }

    /**
     * Open a session for a worker and get its turn 0
     */
    async attachWorkerRaw(requestParameters: AttachWorkerRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Turn>> {
        const requestOptions = await this.attachWorkerRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => TurnFromJSON(jsonValue));
    }

    /**
     * Open a session for a worker and get its turn 0
     */
    async attachWorker(requestParameters: AttachWorkerRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Turn> {
        const response = await this.attachWorkerRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for detachWorker without sending the request
     */
    async detachWorkerRequestOpts(requestParameters: DetachWorkerRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling detachWorker().'
            );
        }

        if (requestParameters['workerId'] == null) {
            throw new runtime.RequiredError(
                'workerId',
                'Required parameter "workerId" was null or undefined when calling detachWorker().'
            );
        }

        if (requestParameters['sessionId'] == null) {
            throw new runtime.RequiredError(
                'sessionId',
                'Required parameter "sessionId" was null or undefined when calling detachWorker().'
            );
        }

        const queryParameters: any = {};

        if (requestParameters['sessionId'] != null) {
            queryParameters['session_id'] = requestParameters['sessionId'];
        }

        const headerParameters: runtime.HTTPHeaders = {};

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/workers/{worker_id}`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));
        urlPath = urlPath.replace('{worker_id}', encodeURIComponent(String(requestParameters['workerId'])));

        return {
            path: urlPath,
            method: 'DELETE',
            headers: headerParameters,
            query: queryParameters,
        };
    }

    /**
     * Close a session and free its slot at once
     */
    async detachWorkerRaw(requestParameters: DetachWorkerRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<void>> {
        const requestOptions = await this.detachWorkerRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.VoidApiResponse(response);
    }

    /**
     * Close a session and free its slot at once
     */
    async detachWorker(requestParameters: DetachWorkerRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<void> {
        await this.detachWorkerRaw(requestParameters, initOverrides);
    }

    /**
     * Creates request options for heartbeat without sending the request
     */
    async heartbeatRequestOpts(requestParameters: HeartbeatRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling heartbeat().'
            );
        }

        if (requestParameters['workerId'] == null) {
            throw new runtime.RequiredError(
                'workerId',
                'Required parameter "workerId" was null or undefined when calling heartbeat().'
            );
        }

        if (requestParameters['heartbeat'] == null) {
            throw new runtime.RequiredError(
                'heartbeat',
                'Required parameter "heartbeat" was null or undefined when calling heartbeat().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/json';

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/workers/{worker_id}/heartbeat`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));
        urlPath = urlPath.replace('{worker_id}', encodeURIComponent(String(requestParameters['workerId'])));

        return {
            path: urlPath,
            method: 'POST',
            headers: headerParameters,
            query: queryParameters,
            body: HeartbeatToJSON(requestParameters['heartbeat']),
        };
    }

    /**
     * Extend the lease while the policy thinks
     */
    async heartbeatRaw(requestParameters: HeartbeatRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Lease>> {
        const requestOptions = await this.heartbeatRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => LeaseFromJSON(jsonValue));
    }

    /**
     * Extend the lease while the policy thinks
     */
    async heartbeat(requestParameters: HeartbeatRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Lease> {
        const response = await this.heartbeatRaw(requestParameters, initOverrides);
        return await response.value();
    }

    /**
     * Creates request options for predict without sending the request
     */
    async predictRequestOpts(requestParameters: PredictRequest): Promise<runtime.RequestOpts> {
        if (requestParameters['runId'] == null) {
            throw new runtime.RequiredError(
                'runId',
                'Required parameter "runId" was null or undefined when calling predict().'
            );
        }

        if (requestParameters['workerId'] == null) {
            throw new runtime.RequiredError(
                'workerId',
                'Required parameter "workerId" was null or undefined when calling predict().'
            );
        }

        if (requestParameters['predict'] == null) {
            throw new runtime.RequiredError(
                'predict',
                'Required parameter "predict" was null or undefined when calling predict().'
            );
        }

        const queryParameters: any = {};

        const headerParameters: runtime.HTTPHeaders = {};

        headerParameters['Content-Type'] = 'application/json';

        if (requestParameters['proctorVersion'] != null) {
            headerParameters['Proctor-Version'] = String(requestParameters['proctorVersion']);
        }

        if (this.configuration && this.configuration.accessToken) {
            const token = this.configuration.accessToken;
            const tokenString = await token("bearer", []);

            if (tokenString) {
                headerParameters["Authorization"] = `Bearer ${tokenString}`;
            }
        }

        let urlPath = `/v1/runs/{run_id}/workers/{worker_id}/predict`;
        urlPath = urlPath.replace('{run_id}', encodeURIComponent(String(requestParameters['runId'])));
        urlPath = urlPath.replace('{worker_id}', encodeURIComponent(String(requestParameters['workerId'])));

        return {
            path: urlPath,
            method: 'POST',
            headers: headerParameters,
            query: queryParameters,
            body: PredictToJSON(requestParameters['predict']),
        };
    }

    /**
     * A chunk of actions in, the next observation out
     */
    async predictRaw(requestParameters: PredictRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<runtime.ApiResponse<Turn>> {
        const requestOptions = await this.predictRequestOpts(requestParameters);
        const response = await this.request(requestOptions, initOverrides);

        return new runtime.JSONApiResponse(response, (jsonValue) => TurnFromJSON(jsonValue));
    }

    /**
     * A chunk of actions in, the next observation out
     */
    async predict(requestParameters: PredictRequest, initOverrides?: RequestInit | runtime.InitOverrideFunction): Promise<Turn> {
        const response = await this.predictRaw(requestParameters, initOverrides);
        return await response.value();
    }

}
