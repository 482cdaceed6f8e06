/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.api;

import proctor.client.ApiCallback;
import proctor.client.ApiClient;
import proctor.client.ApiException;
import proctor.client.ApiResponse;
import proctor.client.Configuration;
import proctor.client.Pair;
import proctor.client.ProgressRequestBody;
import proctor.client.ProgressResponseBody;

import com.google.gson.reflect.TypeToken;

import java.io.IOException;


import proctor.client.model.AttachWorker;
import proctor.client.model.Heartbeat;
import proctor.client.model.Lease;
import proctor.client.model.Predict;
import proctor.client.model.Problem;
import proctor.client.model.Turn;

import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

public class DataApi {
    private ApiClient localVarApiClient;
    private int localHostIndex;
    private String localCustomBaseUrl;

    public DataApi() {
        this(Configuration.getDefaultApiClient());
    }

    public DataApi(ApiClient apiClient) {
        this.localVarApiClient = apiClient;
    }

    public ApiClient getApiClient() {
        return localVarApiClient;
    }

    public void setApiClient(ApiClient apiClient) {
        this.localVarApiClient = apiClient;
    }

    public int getHostIndex() {
        return localHostIndex;
    }

    public void setHostIndex(int hostIndex) {
        this.localHostIndex = hostIndex;
    }

    public String getCustomBaseUrl() {
        return localCustomBaseUrl;
    }

    public void setCustomBaseUrl(String customBaseUrl) {
        this.localCustomBaseUrl = customBaseUrl;
    }

    /**
     * Build call for attachWorker
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param attachWorker  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The session&#39;s latest turn; turn 0 for a new session. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call attachWorkerCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull AttachWorker attachWorker, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        String basePath = null;
        // Operation Servers
        String[] localBasePaths = new String[] {  };

        // Determine Base Path to Use
        if (localCustomBaseUrl != null){
            basePath = localCustomBaseUrl;
        } else if ( localBasePaths.length > 0 ) {
            basePath = localBasePaths[localHostIndex];
        } else {
            basePath = null;
        }

        Object localVarPostBody = attachWorker;

        // create path and map variables
        String localVarPath = "/v1/runs/{run_id}/workers/{worker_id}"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()))
            .replace("{" + "worker_id" + "}", localVarApiClient.escapeString(workerId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        final String[] localVarAccepts = {
            "application/json",
            "application/msgpack",
            "application/problem+json"
        };
        final String localVarAccept = localVarApiClient.selectHeaderAccept(localVarAccepts);
        if (localVarAccept != null) {
            localVarHeaderParams.put("Accept", localVarAccept);
        }

        final String[] localVarContentTypes = {
            "application/json",
            "application/msgpack"
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "PUT", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call attachWorkerValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull AttachWorker attachWorker, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling attachWorker(Async)");
        }

        // verify the required parameter 'workerId' is set
        if (workerId == null) {
            throw new ApiException("Missing the required parameter 'workerId' when calling attachWorker(Async)");
        }

        // verify the required parameter 'attachWorker' is set
        if (attachWorker == null) {
            throw new ApiException("Missing the required parameter 'attachWorker' when calling attachWorker(Async)");
        }

        return attachWorkerCall(runId, workerId, attachWorker, proctorVersion, _callback);

    }

    /**
     * Open a session for a worker and get its turn 0
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param attachWorker  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Turn
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The session&#39;s latest turn; turn 0 for a new session. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Turn attachWorker(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull AttachWorker attachWorker, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Turn> localVarResp = attachWorkerWithHttpInfo(runId, workerId, attachWorker, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Open a session for a worker and get its turn 0
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param attachWorker  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Turn&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The session&#39;s latest turn; turn 0 for a new session. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Turn> attachWorkerWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull AttachWorker attachWorker, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = attachWorkerValidateBeforeCall(runId, workerId, attachWorker, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Turn>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Open a session for a worker and get its turn 0 (asynchronously)
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param attachWorker  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The session&#39;s latest turn; turn 0 for a new session. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call attachWorkerAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull AttachWorker attachWorker, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Turn> _callback) throws ApiException {

        okhttp3.Call localVarCall = attachWorkerValidateBeforeCall(runId, workerId, attachWorker, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Turn>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for detachWorker
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param sessionId The session to close. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> The session is closed. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call detachWorkerCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull String sessionId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        String basePath = null;
        // Operation Servers
        String[] localBasePaths = new String[] {  };

        // Determine Base Path to Use
        if (localCustomBaseUrl != null){
            basePath = localCustomBaseUrl;
        } else if ( localBasePaths.length > 0 ) {
            basePath = localBasePaths[localHostIndex];
        } else {
            basePath = null;
        }

        Object localVarPostBody = null;

        // create path and map variables
        String localVarPath = "/v1/runs/{run_id}/workers/{worker_id}"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()))
            .replace("{" + "worker_id" + "}", localVarApiClient.escapeString(workerId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (sessionId != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("session_id", sessionId));
        }

        final String[] localVarAccepts = {
            "application/problem+json"
        };
        final String localVarAccept = localVarApiClient.selectHeaderAccept(localVarAccepts);
        if (localVarAccept != null) {
            localVarHeaderParams.put("Accept", localVarAccept);
        }

        final String[] localVarContentTypes = {
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "DELETE", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call detachWorkerValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull String sessionId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling detachWorker(Async)");
        }

        // verify the required parameter 'workerId' is set
        if (workerId == null) {
            throw new ApiException("Missing the required parameter 'workerId' when calling detachWorker(Async)");
        }

        // verify the required parameter 'sessionId' is set
        if (sessionId == null) {
            throw new ApiException("Missing the required parameter 'sessionId' when calling detachWorker(Async)");
        }

        return detachWorkerCall(runId, workerId, sessionId, proctorVersion, _callback);

    }

    /**
     * Close a session and free its slot at once
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param sessionId The session to close. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> The session is closed. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public void detachWorker(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull String sessionId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        detachWorkerWithHttpInfo(runId, workerId, sessionId, proctorVersion);
    }

    /**
     * Close a session and free its slot at once
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param sessionId The session to close. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Void&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> The session is closed. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Void> detachWorkerWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull String sessionId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = detachWorkerValidateBeforeCall(runId, workerId, sessionId, proctorVersion, null);
        return localVarApiClient.execute(localVarCall);
    }

    /**
     * Close a session and free its slot at once (asynchronously)
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param sessionId The session to close. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> The session is closed. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call detachWorkerAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull String sessionId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Void> _callback) throws ApiException {

        okhttp3.Call localVarCall = detachWorkerValidateBeforeCall(runId, workerId, sessionId, proctorVersion, _callback);
        localVarApiClient.executeAsync(localVarCall, _callback);
        return localVarCall;
    }
    /**
     * Build call for heartbeat
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param heartbeat  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The lease as extended. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call heartbeatCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Heartbeat heartbeat, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        String basePath = null;
        // Operation Servers
        String[] localBasePaths = new String[] {  };

        // Determine Base Path to Use
        if (localCustomBaseUrl != null){
            basePath = localCustomBaseUrl;
        } else if ( localBasePaths.length > 0 ) {
            basePath = localBasePaths[localHostIndex];
        } else {
            basePath = null;
        }

        Object localVarPostBody = heartbeat;

        // create path and map variables
        String localVarPath = "/v1/runs/{run_id}/workers/{worker_id}/heartbeat"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()))
            .replace("{" + "worker_id" + "}", localVarApiClient.escapeString(workerId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        final String[] localVarAccepts = {
            "application/json",
            "application/problem+json"
        };
        final String localVarAccept = localVarApiClient.selectHeaderAccept(localVarAccepts);
        if (localVarAccept != null) {
            localVarHeaderParams.put("Accept", localVarAccept);
        }

        final String[] localVarContentTypes = {
            "application/json"
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "POST", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call heartbeatValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Heartbeat heartbeat, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling heartbeat(Async)");
        }

        // verify the required parameter 'workerId' is set
        if (workerId == null) {
            throw new ApiException("Missing the required parameter 'workerId' when calling heartbeat(Async)");
        }

        // verify the required parameter 'heartbeat' is set
        if (heartbeat == null) {
            throw new ApiException("Missing the required parameter 'heartbeat' when calling heartbeat(Async)");
        }

        return heartbeatCall(runId, workerId, heartbeat, proctorVersion, _callback);

    }

    /**
     * Extend the lease while the policy thinks
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param heartbeat  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Lease
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The lease as extended. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Lease heartbeat(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Heartbeat heartbeat, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Lease> localVarResp = heartbeatWithHttpInfo(runId, workerId, heartbeat, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Extend the lease while the policy thinks
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param heartbeat  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Lease&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The lease as extended. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Lease> heartbeatWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Heartbeat heartbeat, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = heartbeatValidateBeforeCall(runId, workerId, heartbeat, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Lease>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Extend the lease while the policy thinks (asynchronously)
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param heartbeat  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The lease as extended. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call heartbeatAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Heartbeat heartbeat, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Lease> _callback) throws ApiException {

        okhttp3.Call localVarCall = heartbeatValidateBeforeCall(runId, workerId, heartbeat, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Lease>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for predict
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param predict  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The turn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call predictCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Predict predict, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        String basePath = null;
        // Operation Servers
        String[] localBasePaths = new String[] {  };

        // Determine Base Path to Use
        if (localCustomBaseUrl != null){
            basePath = localCustomBaseUrl;
        } else if ( localBasePaths.length > 0 ) {
            basePath = localBasePaths[localHostIndex];
        } else {
            basePath = null;
        }

        Object localVarPostBody = predict;

        // create path and map variables
        String localVarPath = "/v1/runs/{run_id}/workers/{worker_id}/predict"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()))
            .replace("{" + "worker_id" + "}", localVarApiClient.escapeString(workerId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        final String[] localVarAccepts = {
            "application/json",
            "application/msgpack",
            "application/problem+json"
        };
        final String localVarAccept = localVarApiClient.selectHeaderAccept(localVarAccepts);
        if (localVarAccept != null) {
            localVarHeaderParams.put("Accept", localVarAccept);
        }

        final String[] localVarContentTypes = {
            "application/json",
            "application/msgpack"
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "POST", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call predictValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Predict predict, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling predict(Async)");
        }

        // verify the required parameter 'workerId' is set
        if (workerId == null) {
            throw new ApiException("Missing the required parameter 'workerId' when calling predict(Async)");
        }

        // verify the required parameter 'predict' is set
        if (predict == null) {
            throw new ApiException("Missing the required parameter 'predict' when calling predict(Async)");
        }

        return predictCall(runId, workerId, predict, proctorVersion, _callback);

    }

    /**
     * A chunk of actions in, the next observation out
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param predict  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Turn
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The turn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Turn predict(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Predict predict, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Turn> localVarResp = predictWithHttpInfo(runId, workerId, predict, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * A chunk of actions in, the next observation out
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param predict  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Turn&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The turn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Turn> predictWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Predict predict, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = predictValidateBeforeCall(runId, workerId, predict, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Turn>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * A chunk of actions in, the next observation out (asynchronously)
     *
     * @param runId  (required)
     * @param workerId Chosen by the client; stable over re-attachments. (required)
     * @param predict  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The turn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call predictAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull String workerId, @javax.annotation.Nonnull Predict predict, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Turn> _callback) throws ApiException {

        okhttp3.Call localVarCall = predictValidateBeforeCall(runId, workerId, predict, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Turn>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
}
