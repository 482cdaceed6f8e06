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


import proctor.client.model.Benchmark;
import proctor.client.model.BenchmarkList;
import proctor.client.model.BoardEntry;
import proctor.client.model.BoardEntryList;
import proctor.client.model.Checkpoint;
import proctor.client.model.Comparison;
import proctor.client.model.ConsistencyProof;
import proctor.client.model.EpisodeList;
import proctor.client.model.FlagEntry;
import proctor.client.model.HistoryPage;
import proctor.client.model.InclusionProof;
import proctor.client.model.KeyList;
import proctor.client.model.Problem;
import proctor.client.model.PublishEntry;
import proctor.client.model.Ranking;
import proctor.client.model.RecordImport;
import proctor.client.model.RecordImportList;
import proctor.client.model.Run;
import proctor.client.model.RunList;
import proctor.client.model.Score;
import proctor.client.model.Service;
import proctor.client.model.StopRun;
import proctor.client.model.SubmitRun;

import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

public class ControlApi {
    private ApiClient localVarApiClient;
    private int localHostIndex;
    private String localCustomBaseUrl;

    public ControlApi() {
        this(Configuration.getDefaultApiClient());
    }

    public ControlApi(ApiClient apiClient) {
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
     * Build call for compareRuns
     * @param baseline The run that the others are compared with. (required)
     * @param runs Ids of one to sixteen runs, with commas between them; the baseline may be one of them. (required)
     * @param tolerance The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The comparison. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call compareRunsCall(@javax.annotation.Nonnull String baseline, @javax.annotation.Nonnull String runs, @javax.annotation.Nullable Double tolerance, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/comparisons";

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (baseline != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("baseline", baseline));
        }

        if (runs != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("runs", runs));
        }

        if (tolerance != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("tolerance", tolerance));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call compareRunsValidateBeforeCall(@javax.annotation.Nonnull String baseline, @javax.annotation.Nonnull String runs, @javax.annotation.Nullable Double tolerance, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'baseline' is set
        if (baseline == null) {
            throw new ApiException("Missing the required parameter 'baseline' when calling compareRuns(Async)");
        }

        // verify the required parameter 'runs' is set
        if (runs == null) {
            throw new ApiException("Missing the required parameter 'runs' when calling compareRuns(Async)");
        }

        return compareRunsCall(baseline, runs, tolerance, proctorVersion, _callback);

    }

    /**
     * Runs beside a baseline, episode by episode
     * Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
     * @param baseline The run that the others are compared with. (required)
     * @param runs Ids of one to sixteen runs, with commas between them; the baseline may be one of them. (required)
     * @param tolerance The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Comparison
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The comparison. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Comparison compareRuns(@javax.annotation.Nonnull String baseline, @javax.annotation.Nonnull String runs, @javax.annotation.Nullable Double tolerance, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Comparison> localVarResp = compareRunsWithHttpInfo(baseline, runs, tolerance, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Runs beside a baseline, episode by episode
     * Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
     * @param baseline The run that the others are compared with. (required)
     * @param runs Ids of one to sixteen runs, with commas between them; the baseline may be one of them. (required)
     * @param tolerance The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Comparison&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The comparison. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Comparison> compareRunsWithHttpInfo(@javax.annotation.Nonnull String baseline, @javax.annotation.Nonnull String runs, @javax.annotation.Nullable Double tolerance, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = compareRunsValidateBeforeCall(baseline, runs, tolerance, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Comparison>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Runs beside a baseline, episode by episode (asynchronously)
     * Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
     * @param baseline The run that the others are compared with. (required)
     * @param runs Ids of one to sixteen runs, with commas between them; the baseline may be one of them. (required)
     * @param tolerance The largest difference that &#x60;release&#x60; lets pass; 0.05 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The comparison. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call compareRunsAsync(@javax.annotation.Nonnull String baseline, @javax.annotation.Nonnull String runs, @javax.annotation.Nullable Double tolerance, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Comparison> _callback) throws ApiException {

        okhttp3.Call localVarCall = compareRunsValidateBeforeCall(baseline, runs, tolerance, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Comparison>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for deleteImport
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> It is gone. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call deleteImportCall(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/records/{import_id}"
            .replace("{" + "import_id" + "}", localVarApiClient.escapeString(importId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

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
    private okhttp3.Call deleteImportValidateBeforeCall(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'importId' is set
        if (importId == null) {
            throw new ApiException("Missing the required parameter 'importId' when calling deleteImport(Async)");
        }

        return deleteImportCall(importId, proctorVersion, _callback);

    }

    /**
     * Remove a record that was handed in
     * What was read of it and its replay are forgotten. Offered with the profile &#x60;record_import&#x60;.
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> It is gone. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public void deleteImport(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        deleteImportWithHttpInfo(importId, proctorVersion);
    }

    /**
     * Remove a record that was handed in
     * What was read of it and its replay are forgotten. Offered with the profile &#x60;record_import&#x60;.
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Void&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> It is gone. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Void> deleteImportWithHttpInfo(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = deleteImportValidateBeforeCall(importId, proctorVersion, null);
        return localVarApiClient.execute(localVarCall);
    }

    /**
     * Remove a record that was handed in (asynchronously)
     * What was read of it and its replay are forgotten. Offered with the profile &#x60;record_import&#x60;.
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> It is gone. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call deleteImportAsync(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Void> _callback) throws ApiException {

        okhttp3.Call localVarCall = deleteImportValidateBeforeCall(importId, proctorVersion, _callback);
        localVarApiClient.executeAsync(localVarCall, _callback);
        return localVarCall;
    }
    /**
     * Build call for deleteRun
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> Deleted; the run is no more. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call deleteRunCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/runs/{run_id}"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

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
    private okhttp3.Call deleteRunValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling deleteRun(Async)");
        }

        return deleteRunCall(runId, proctorVersion, _callback);

    }

    /**
     * Delete a run that is not in play, with all that is stored of it
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> Deleted; the run is no more. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public void deleteRun(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        deleteRunWithHttpInfo(runId, proctorVersion);
    }

    /**
     * Delete a run that is not in play, with all that is stored of it
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Void&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> Deleted; the run is no more. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Void> deleteRunWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = deleteRunValidateBeforeCall(runId, proctorVersion, null);
        return localVarApiClient.execute(localVarCall);
    }

    /**
     * Delete a run that is not in play, with all that is stored of it (asynchronously)
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 204 </td><td> Deleted; the run is no more. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call deleteRunAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Void> _callback) throws ApiException {

        okhttp3.Call localVarCall = deleteRunValidateBeforeCall(runId, proctorVersion, _callback);
        localVarApiClient.executeAsync(localVarCall, _callback);
        return localVarCall;
    }
    /**
     * Build call for describeService
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The service. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call describeServiceCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1";

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] {  };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call describeServiceValidateBeforeCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return describeServiceCall(proctorVersion, _callback);

    }

    /**
     * What this server is, speaks and allows
     *
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Service
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The service. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Service describeService(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Service> localVarResp = describeServiceWithHttpInfo(proctorVersion);
        return localVarResp.getData();
    }

    /**
     * What this server is, speaks and allows
     *
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Service&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The service. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Service> describeServiceWithHttpInfo(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = describeServiceValidateBeforeCall(proctorVersion, null);
        Type localVarReturnType = new TypeToken<Service>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * What this server is, speaks and allows (asynchronously)
     *
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The service. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call describeServiceAsync(@javax.annotation.Nullable String proctorVersion, final ApiCallback<Service> _callback) throws ApiException {

        okhttp3.Call localVarCall = describeServiceValidateBeforeCall(proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Service>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for flagEntry
     * @param entryId  (required)
     * @param flagEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call flagEntryCall(@javax.annotation.Nonnull String entryId, @javax.annotation.Nonnull FlagEntry flagEntry, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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

        Object localVarPostBody = flagEntry;

        // create path and map variables
        String localVarPath = "/v1/entries/{entry_id}/flag"
            .replace("{" + "entry_id" + "}", localVarApiClient.escapeString(entryId.toString()));

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
        return localVarApiClient.buildCall(basePath, localVarPath, "PUT", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call flagEntryValidateBeforeCall(@javax.annotation.Nonnull String entryId, @javax.annotation.Nonnull FlagEntry flagEntry, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'entryId' is set
        if (entryId == null) {
            throw new ApiException("Missing the required parameter 'entryId' when calling flagEntry(Async)");
        }

        // verify the required parameter 'flagEntry' is set
        if (flagEntry == null) {
            throw new ApiException("Missing the required parameter 'flagEntry' when calling flagEntry(Async)");
        }

        return flagEntryCall(entryId, flagEntry, proctorVersion, _callback);

    }

    /**
     * Say of a public entry that something is wrong with it, or take that back
     * For the host: the token needs the scope &#x60;host&#x60;, besides &#x60;run&#x60;. A flagged entry is shown with the reason, and has no rank.
     * @param entryId  (required)
     * @param flagEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return BoardEntry
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public BoardEntry flagEntry(@javax.annotation.Nonnull String entryId, @javax.annotation.Nonnull FlagEntry flagEntry, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<BoardEntry> localVarResp = flagEntryWithHttpInfo(entryId, flagEntry, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Say of a public entry that something is wrong with it, or take that back
     * For the host: the token needs the scope &#x60;host&#x60;, besides &#x60;run&#x60;. A flagged entry is shown with the reason, and has no rank.
     * @param entryId  (required)
     * @param flagEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;BoardEntry&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<BoardEntry> flagEntryWithHttpInfo(@javax.annotation.Nonnull String entryId, @javax.annotation.Nonnull FlagEntry flagEntry, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = flagEntryValidateBeforeCall(entryId, flagEntry, proctorVersion, null);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Say of a public entry that something is wrong with it, or take that back (asynchronously)
     * For the host: the token needs the scope &#x60;host&#x60;, besides &#x60;run&#x60;. A flagged entry is shown with the reason, and has no rank.
     * @param entryId  (required)
     * @param flagEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call flagEntryAsync(@javax.annotation.Nonnull String entryId, @javax.annotation.Nonnull FlagEntry flagEntry, @javax.annotation.Nullable String proctorVersion, final ApiCallback<BoardEntry> _callback) throws ApiException {

        okhttp3.Call localVarCall = flagEntryValidateBeforeCall(entryId, flagEntry, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for getBenchmark
     * @param benchmarkId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The benchmark. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getBenchmarkCall(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/benchmarks/{benchmark_id}"
            .replace("{" + "benchmark_id" + "}", localVarApiClient.escapeString(benchmarkId.toString()));

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call getBenchmarkValidateBeforeCall(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'benchmarkId' is set
        if (benchmarkId == null) {
            throw new ApiException("Missing the required parameter 'benchmarkId' when calling getBenchmark(Async)");
        }

        return getBenchmarkCall(benchmarkId, proctorVersion, _callback);

    }

    /**
     * One benchmark with its spaces, conventions and rules
     *
     * @param benchmarkId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Benchmark
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The benchmark. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Benchmark getBenchmark(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Benchmark> localVarResp = getBenchmarkWithHttpInfo(benchmarkId, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * One benchmark with its spaces, conventions and rules
     *
     * @param benchmarkId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Benchmark&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The benchmark. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Benchmark> getBenchmarkWithHttpInfo(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = getBenchmarkValidateBeforeCall(benchmarkId, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Benchmark>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * One benchmark with its spaces, conventions and rules (asynchronously)
     *
     * @param benchmarkId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The benchmark. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getBenchmarkAsync(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Benchmark> _callback) throws ApiException {

        okhttp3.Call localVarCall = getBenchmarkValidateBeforeCall(benchmarkId, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Benchmark>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for getCheckpoint
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The checkpoint of all leaves that there are now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getCheckpointCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/history/checkpoint";

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call getCheckpointValidateBeforeCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return getCheckpointCall(proctorVersion, _callback);

    }

    /**
     * The size and the root of the history, signed
     * A signed note, as board.md has it, by the key of &#x60;list_keys&#x60; that is in use.
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Checkpoint
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The checkpoint of all leaves that there are now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Checkpoint getCheckpoint(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Checkpoint> localVarResp = getCheckpointWithHttpInfo(proctorVersion);
        return localVarResp.getData();
    }

    /**
     * The size and the root of the history, signed
     * A signed note, as board.md has it, by the key of &#x60;list_keys&#x60; that is in use.
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Checkpoint&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The checkpoint of all leaves that there are now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Checkpoint> getCheckpointWithHttpInfo(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = getCheckpointValidateBeforeCall(proctorVersion, null);
        Type localVarReturnType = new TypeToken<Checkpoint>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * The size and the root of the history, signed (asynchronously)
     * A signed note, as board.md has it, by the key of &#x60;list_keys&#x60; that is in use.
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The checkpoint of all leaves that there are now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getCheckpointAsync(@javax.annotation.Nullable String proctorVersion, final ApiCallback<Checkpoint> _callback) throws ApiException {

        okhttp3.Call localVarCall = getCheckpointValidateBeforeCall(proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Checkpoint>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for getEntry
     * @param entryId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getEntryCall(@javax.annotation.Nonnull String entryId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/entries/{entry_id}"
            .replace("{" + "entry_id" + "}", localVarApiClient.escapeString(entryId.toString()));

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call getEntryValidateBeforeCall(@javax.annotation.Nonnull String entryId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'entryId' is set
        if (entryId == null) {
            throw new ApiException("Missing the required parameter 'entryId' when calling getEntry(Async)");
        }

        return getEntryCall(entryId, proctorVersion, _callback);

    }

    /**
     * One entry, withdrawn or not
     * Of another account only if it is public, or was when it was withdrawn.
     * @param entryId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return BoardEntry
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public BoardEntry getEntry(@javax.annotation.Nonnull String entryId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<BoardEntry> localVarResp = getEntryWithHttpInfo(entryId, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * One entry, withdrawn or not
     * Of another account only if it is public, or was when it was withdrawn.
     * @param entryId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;BoardEntry&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<BoardEntry> getEntryWithHttpInfo(@javax.annotation.Nonnull String entryId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = getEntryValidateBeforeCall(entryId, proctorVersion, null);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * One entry, withdrawn or not (asynchronously)
     * Of another account only if it is public, or was when it was withdrawn.
     * @param entryId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getEntryAsync(@javax.annotation.Nonnull String entryId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<BoardEntry> _callback) throws ApiException {

        okhttp3.Call localVarCall = getEntryValidateBeforeCall(entryId, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for getImport
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The import. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getImportCall(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/records/{import_id}"
            .replace("{" + "import_id" + "}", localVarApiClient.escapeString(importId.toString()));

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call getImportValidateBeforeCall(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'importId' is set
        if (importId == null) {
            throw new ApiException("Missing the required parameter 'importId' when calling getImport(Async)");
        }

        return getImportCall(importId, proctorVersion, _callback);

    }

    /**
     * What is known here of a record that was handed in
     * Offered with the profile &#x60;record_import&#x60;.
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return RecordImport
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The import. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public RecordImport getImport(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<RecordImport> localVarResp = getImportWithHttpInfo(importId, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * What is known here of a record that was handed in
     * Offered with the profile &#x60;record_import&#x60;.
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;RecordImport&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The import. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<RecordImport> getImportWithHttpInfo(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = getImportValidateBeforeCall(importId, proctorVersion, null);
        Type localVarReturnType = new TypeToken<RecordImport>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * What is known here of a record that was handed in (asynchronously)
     * Offered with the profile &#x60;record_import&#x60;.
     * @param importId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The import. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getImportAsync(@javax.annotation.Nonnull String importId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<RecordImport> _callback) throws ApiException {

        okhttp3.Call localVarCall = getImportValidateBeforeCall(importId, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<RecordImport>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for getRanking
     * @param benchmarkId  (required)
     * @param manifestSha256 Which manifest; that of &#x60;get_benchmark&#x60; when absent. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page of its rows, the highest score first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getRankingCall(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String manifestSha256, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/benchmarks/{benchmark_id}/ranking"
            .replace("{" + "benchmark_id" + "}", localVarApiClient.escapeString(benchmarkId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (manifestSha256 != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("manifest_sha256", manifestSha256));
        }

        if (cursor != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("cursor", cursor));
        }

        if (limit != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("limit", limit));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call getRankingValidateBeforeCall(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String manifestSha256, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'benchmarkId' is set
        if (benchmarkId == null) {
            throw new ApiException("Missing the required parameter 'benchmarkId' when calling getRanking(Async)");
        }

        return getRankingCall(benchmarkId, manifestSha256, cursor, limit, proctorVersion, _callback);

    }

    /**
     * The public entries of one manifest, ranked
     * One ranking for every caller; private entries do not enter. board.md has the arithmetic.
     * @param benchmarkId  (required)
     * @param manifestSha256 Which manifest; that of &#x60;get_benchmark&#x60; when absent. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Ranking
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page of its rows, the highest score first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Ranking getRanking(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String manifestSha256, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Ranking> localVarResp = getRankingWithHttpInfo(benchmarkId, manifestSha256, cursor, limit, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * The public entries of one manifest, ranked
     * One ranking for every caller; private entries do not enter. board.md has the arithmetic.
     * @param benchmarkId  (required)
     * @param manifestSha256 Which manifest; that of &#x60;get_benchmark&#x60; when absent. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Ranking&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page of its rows, the highest score first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Ranking> getRankingWithHttpInfo(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String manifestSha256, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = getRankingValidateBeforeCall(benchmarkId, manifestSha256, cursor, limit, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Ranking>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * The public entries of one manifest, ranked (asynchronously)
     * One ranking for every caller; private entries do not enter. board.md has the arithmetic.
     * @param benchmarkId  (required)
     * @param manifestSha256 Which manifest; that of &#x60;get_benchmark&#x60; when absent. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page of its rows, the highest score first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getRankingAsync(@javax.annotation.Nonnull String benchmarkId, @javax.annotation.Nullable String manifestSha256, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Ranking> _callback) throws ApiException {

        okhttp3.Call localVarCall = getRankingValidateBeforeCall(benchmarkId, manifestSha256, cursor, limit, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Ranking>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for getRun
     * @param runId  (required)
     * @param ifNoneMatch The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. A tag with &#x60;W/&#x60; before it may name the same as without. (optional)
     * @param prefer &#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run. </td><td>  * Proctor-Version -  <br>  * ETag - Changes whenever any member of the run changes. <br>  </td></tr>
        <tr><td> 304 </td><td> Unchanged since the ETag in If-None-Match. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getRunCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String ifNoneMatch, @javax.annotation.Nullable String prefer, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/runs/{run_id}"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (ifNoneMatch != null) {
            localVarHeaderParams.put("If-None-Match", localVarApiClient.parameterToString(ifNoneMatch));
        }


        if (prefer != null) {
            localVarHeaderParams.put("Prefer", localVarApiClient.parameterToString(prefer));
        }


        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call getRunValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String ifNoneMatch, @javax.annotation.Nullable String prefer, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling getRun(Async)");
        }

        return getRunCall(runId, ifNoneMatch, prefer, proctorVersion, _callback);

    }

    /**
     * State, progress and the reason for both; can wait for a change
     *
     * @param runId  (required)
     * @param ifNoneMatch The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. A tag with &#x60;W/&#x60; before it may name the same as without. (optional)
     * @param prefer &#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Run
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run. </td><td>  * Proctor-Version -  <br>  * ETag - Changes whenever any member of the run changes. <br>  </td></tr>
        <tr><td> 304 </td><td> Unchanged since the ETag in If-None-Match. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Run getRun(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String ifNoneMatch, @javax.annotation.Nullable String prefer, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Run> localVarResp = getRunWithHttpInfo(runId, ifNoneMatch, prefer, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * State, progress and the reason for both; can wait for a change
     *
     * @param runId  (required)
     * @param ifNoneMatch The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. A tag with &#x60;W/&#x60; before it may name the same as without. (optional)
     * @param prefer &#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Run&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run. </td><td>  * Proctor-Version -  <br>  * ETag - Changes whenever any member of the run changes. <br>  </td></tr>
        <tr><td> 304 </td><td> Unchanged since the ETag in If-None-Match. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Run> getRunWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String ifNoneMatch, @javax.annotation.Nullable String prefer, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = getRunValidateBeforeCall(runId, ifNoneMatch, prefer, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * State, progress and the reason for both; can wait for a change (asynchronously)
     *
     * @param runId  (required)
     * @param ifNoneMatch The ETag of the last answer, a list of some, or &#x60;*&#x60;; while one of them holds, the answer is 304. A text that is no ETag names none. A tag with &#x60;W/&#x60; before it may name the same as without. (optional)
     * @param prefer &#x60;wait&#x3D;N&#x60; holds the answer back for up to N seconds until the ETag in If-None-Match no longer holds. Longer than &#x60;limits.wait_s_max&#x60; is granted as that; without If-None-Match nothing is waited for. Any other value is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run. </td><td>  * Proctor-Version -  <br>  * ETag - Changes whenever any member of the run changes. <br>  </td></tr>
        <tr><td> 304 </td><td> Unchanged since the ETag in If-None-Match. </td><td>  -  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getRunAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String ifNoneMatch, @javax.annotation.Nullable String prefer, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Run> _callback) throws ApiException {

        okhttp3.Call localVarCall = getRunValidateBeforeCall(runId, ifNoneMatch, prefer, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for getScore
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The score. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getScoreCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/runs/{run_id}/score"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call getScoreValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling getScore(Async)");
        }

        return getScoreCall(runId, proctorVersion, _callback);

    }

    /**
     * The score, or its bounds while episodes are missing
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Score
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The score. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Score getScore(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Score> localVarResp = getScoreWithHttpInfo(runId, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * The score, or its bounds while episodes are missing
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Score&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The score. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Score> getScoreWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = getScoreValidateBeforeCall(runId, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Score>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * The score, or its bounds while episodes are missing (asynchronously)
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The score. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call getScoreAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Score> _callback) throws ApiException {

        okhttp3.Call localVarCall = getScoreValidateBeforeCall(runId, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Score>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for importRecord
     * @param body  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 202 </td><td> The record is whole, and waits to be replayed. </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call importRecordCall(@javax.annotation.Nonnull String body, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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

        Object localVarPostBody = body;

        // create path and map variables
        String localVarPath = "/v1/records";

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
            "application/zip"
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
    private okhttp3.Call importRecordValidateBeforeCall(@javax.annotation.Nonnull String body, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'body' is set
        if (body == null) {
            throw new ApiException("Missing the required parameter 'body' when calling importRecord(Async)");
        }

        return importRecordCall(body, proctorVersion, _callback);

    }

    /**
     * Hand in a record of any host, to be verified and replayed here
     * The body is the archive that record.md describes; it is verified before the answer, so what is broken is refused with the file and the rule (REC-113). Then it is replayed on this server, when its simulators are free: &#x60;get_import&#x60; shows how far that is, and the level of trust that the record has here. Offered with the profile &#x60;record_import&#x60;. The same bytes, sent again by the account, are the same import.
     * @param body  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return RecordImport
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 202 </td><td> The record is whole, and waits to be replayed. </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public RecordImport importRecord(@javax.annotation.Nonnull String body, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<RecordImport> localVarResp = importRecordWithHttpInfo(body, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Hand in a record of any host, to be verified and replayed here
     * The body is the archive that record.md describes; it is verified before the answer, so what is broken is refused with the file and the rule (REC-113). Then it is replayed on this server, when its simulators are free: &#x60;get_import&#x60; shows how far that is, and the level of trust that the record has here. Offered with the profile &#x60;record_import&#x60;. The same bytes, sent again by the account, are the same import.
     * @param body  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;RecordImport&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 202 </td><td> The record is whole, and waits to be replayed. </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<RecordImport> importRecordWithHttpInfo(@javax.annotation.Nonnull String body, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = importRecordValidateBeforeCall(body, proctorVersion, null);
        Type localVarReturnType = new TypeToken<RecordImport>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Hand in a record of any host, to be verified and replayed here (asynchronously)
     * The body is the archive that record.md describes; it is verified before the answer, so what is broken is refused with the file and the rule (REC-113). Then it is replayed on this server, when its simulators are free: &#x60;get_import&#x60; shows how far that is, and the level of trust that the record has here. Offered with the profile &#x60;record_import&#x60;. The same bytes, sent again by the account, are the same import.
     * @param body  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 202 </td><td> The record is whole, and waits to be replayed. </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call importRecordAsync(@javax.annotation.Nonnull String body, @javax.annotation.Nullable String proctorVersion, final ApiCallback<RecordImport> _callback) throws ApiException {

        okhttp3.Call localVarCall = importRecordValidateBeforeCall(body, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<RecordImport>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for listBenchmarks
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All benchmarks, sorted by id. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listBenchmarksCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/benchmarks";

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call listBenchmarksValidateBeforeCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return listBenchmarksCall(proctorVersion, _callback);

    }

    /**
     * The benchmarks offered here
     *
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return BenchmarkList
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All benchmarks, sorted by id. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public BenchmarkList listBenchmarks(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<BenchmarkList> localVarResp = listBenchmarksWithHttpInfo(proctorVersion);
        return localVarResp.getData();
    }

    /**
     * The benchmarks offered here
     *
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;BenchmarkList&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All benchmarks, sorted by id. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<BenchmarkList> listBenchmarksWithHttpInfo(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = listBenchmarksValidateBeforeCall(proctorVersion, null);
        Type localVarReturnType = new TypeToken<BenchmarkList>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * The benchmarks offered here (asynchronously)
     *
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All benchmarks, sorted by id. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listBenchmarksAsync(@javax.annotation.Nullable String proctorVersion, final ApiCallback<BenchmarkList> _callback) throws ApiException {

        okhttp3.Call localVarCall = listBenchmarksValidateBeforeCall(proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<BenchmarkList>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for listEntries
     * @param benchmarkId Only entries of this benchmark. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listEntriesCall(@javax.annotation.Nullable String benchmarkId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/entries";

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (benchmarkId != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("benchmark_id", benchmarkId));
        }

        if (cursor != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("cursor", cursor));
        }

        if (limit != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("limit", limit));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call listEntriesValidateBeforeCall(@javax.annotation.Nullable String benchmarkId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return listEntriesCall(benchmarkId, cursor, limit, proctorVersion, _callback);

    }

    /**
     * Entries of the leaderboard, newest first
     * Public entries, and private ones of the account that asks; none that is withdrawn.
     * @param benchmarkId Only entries of this benchmark. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return BoardEntryList
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public BoardEntryList listEntries(@javax.annotation.Nullable String benchmarkId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<BoardEntryList> localVarResp = listEntriesWithHttpInfo(benchmarkId, cursor, limit, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Entries of the leaderboard, newest first
     * Public entries, and private ones of the account that asks; none that is withdrawn.
     * @param benchmarkId Only entries of this benchmark. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;BoardEntryList&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<BoardEntryList> listEntriesWithHttpInfo(@javax.annotation.Nullable String benchmarkId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = listEntriesValidateBeforeCall(benchmarkId, cursor, limit, proctorVersion, null);
        Type localVarReturnType = new TypeToken<BoardEntryList>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Entries of the leaderboard, newest first (asynchronously)
     * Public entries, and private ones of the account that asks; none that is withdrawn.
     * @param benchmarkId Only entries of this benchmark. (optional)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listEntriesAsync(@javax.annotation.Nullable String benchmarkId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback<BoardEntryList> _callback) throws ApiException {

        okhttp3.Call localVarCall = listEntriesValidateBeforeCall(benchmarkId, cursor, limit, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<BoardEntryList>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for listEpisodes
     * @param runId  (required)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listEpisodesCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/runs/{run_id}/episodes"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (cursor != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("cursor", cursor));
        }

        if (limit != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("limit", limit));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call listEpisodesValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling listEpisodes(Async)");
        }

        return listEpisodesCall(runId, cursor, limit, proctorVersion, _callback);

    }

    /**
     * Every episode with its result so far, in manifest order
     *
     * @param runId  (required)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return EpisodeList
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public EpisodeList listEpisodes(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<EpisodeList> localVarResp = listEpisodesWithHttpInfo(runId, cursor, limit, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Every episode with its result so far, in manifest order
     *
     * @param runId  (required)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;EpisodeList&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<EpisodeList> listEpisodesWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = listEpisodesValidateBeforeCall(runId, cursor, limit, proctorVersion, null);
        Type localVarReturnType = new TypeToken<EpisodeList>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Every episode with its result so far, in manifest order (asynchronously)
     *
     * @param runId  (required)
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listEpisodesAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback<EpisodeList> _callback) throws ApiException {

        okhttp3.Call localVarCall = listEpisodesValidateBeforeCall(runId, cursor, limit, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<EpisodeList>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for listHistory
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listHistoryCall(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/history";

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (cursor != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("cursor", cursor));
        }

        if (limit != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("limit", limit));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call listHistoryValidateBeforeCall(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return listHistoryCall(cursor, limit, proctorVersion, _callback);

    }

    /**
     * What happened to public entries, oldest first
     * The leaves of the tree of board.md. No leaf is ever changed or taken out.
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return HistoryPage
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public HistoryPage listHistory(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<HistoryPage> localVarResp = listHistoryWithHttpInfo(cursor, limit, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * What happened to public entries, oldest first
     * The leaves of the tree of board.md. No leaf is ever changed or taken out.
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;HistoryPage&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<HistoryPage> listHistoryWithHttpInfo(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = listHistoryValidateBeforeCall(cursor, limit, proctorVersion, null);
        Type localVarReturnType = new TypeToken<HistoryPage>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * What happened to public entries, oldest first (asynchronously)
     * The leaves of the tree of board.md. No leaf is ever changed or taken out.
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listHistoryAsync(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback<HistoryPage> _callback) throws ApiException {

        okhttp3.Call localVarCall = listHistoryValidateBeforeCall(cursor, limit, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<HistoryPage>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for listImports
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listImportsCall(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/records";

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (cursor != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("cursor", cursor));
        }

        if (limit != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("limit", limit));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call listImportsValidateBeforeCall(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return listImportsCall(cursor, limit, proctorVersion, _callback);

    }

    /**
     * The records that the account handed in, newest first
     * Offered with the profile &#x60;record_import&#x60;.
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return RecordImportList
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public RecordImportList listImports(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<RecordImportList> localVarResp = listImportsWithHttpInfo(cursor, limit, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * The records that the account handed in, newest first
     * Offered with the profile &#x60;record_import&#x60;.
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;RecordImportList&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<RecordImportList> listImportsWithHttpInfo(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = listImportsValidateBeforeCall(cursor, limit, proctorVersion, null);
        Type localVarReturnType = new TypeToken<RecordImportList>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * The records that the account handed in, newest first (asynchronously)
     * Offered with the profile &#x60;record_import&#x60;.
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listImportsAsync(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback<RecordImportList> _callback) throws ApiException {

        okhttp3.Call localVarCall = listImportsValidateBeforeCall(cursor, limit, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<RecordImportList>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for listKeys
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All keys, the newest first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listKeysCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/keys";

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
        };
        final String localVarContentType = localVarApiClient.selectHeaderContentType(localVarContentTypes);
        if (localVarContentType != null) {
            localVarHeaderParams.put("Content-Type", localVarContentType);
        }

        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] {  };
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call listKeysValidateBeforeCall(@javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return listKeysCall(proctorVersion, _callback);

    }

    /**
     * The public keys with which this host signs records
     * Offered with the profile &#x60;record&#x60;. Needs no token, as checking a record needs none.
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return KeyList
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All keys, the newest first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public KeyList listKeys(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<KeyList> localVarResp = listKeysWithHttpInfo(proctorVersion);
        return localVarResp.getData();
    }

    /**
     * The public keys with which this host signs records
     * Offered with the profile &#x60;record&#x60;. Needs no token, as checking a record needs none.
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;KeyList&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All keys, the newest first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<KeyList> listKeysWithHttpInfo(@javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = listKeysValidateBeforeCall(proctorVersion, null);
        Type localVarReturnType = new TypeToken<KeyList>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * The public keys with which this host signs records (asynchronously)
     * Offered with the profile &#x60;record&#x60;. Needs no token, as checking a record needs none.
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> All keys, the newest first. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listKeysAsync(@javax.annotation.Nullable String proctorVersion, final ApiCallback<KeyList> _callback) throws ApiException {

        okhttp3.Call localVarCall = listKeysValidateBeforeCall(proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<KeyList>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for listRuns
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listRunsCall(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/runs";

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (cursor != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("cursor", cursor));
        }

        if (limit != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("limit", limit));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call listRunsValidateBeforeCall(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        return listRunsCall(cursor, limit, proctorVersion, _callback);

    }

    /**
     * The caller&#39;s runs, newest first
     *
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return RunList
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public RunList listRuns(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<RunList> localVarResp = listRunsWithHttpInfo(cursor, limit, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * The caller&#39;s runs, newest first
     *
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;RunList&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<RunList> listRunsWithHttpInfo(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = listRunsValidateBeforeCall(cursor, limit, proctorVersion, null);
        Type localVarReturnType = new TypeToken<RunList>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * The caller&#39;s runs, newest first (asynchronously)
     *
     * @param cursor &#x60;next_cursor&#x60; of the page before; opaque to the caller. (optional)
     * @param limit Most items wanted on a page; 100 when absent. (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> One page. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call listRunsAsync(@javax.annotation.Nullable String cursor, @javax.annotation.Nullable Integer limit, @javax.annotation.Nullable String proctorVersion, final ApiCallback<RunList> _callback) throws ApiException {

        okhttp3.Call localVarCall = listRunsValidateBeforeCall(cursor, limit, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<RunList>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for proveConsistency
     * @param oldSize Size of the older history. (required)
     * @param newSize Size of the newer history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call proveConsistencyCall(@javax.annotation.Nonnull String oldSize, @javax.annotation.Nonnull String newSize, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/history/consistency";

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (oldSize != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("old_size", oldSize));
        }

        if (newSize != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("new_size", newSize));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call proveConsistencyValidateBeforeCall(@javax.annotation.Nonnull String oldSize, @javax.annotation.Nonnull String newSize, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'oldSize' is set
        if (oldSize == null) {
            throw new ApiException("Missing the required parameter 'oldSize' when calling proveConsistency(Async)");
        }

        // verify the required parameter 'newSize' is set
        if (newSize == null) {
            throw new ApiException("Missing the required parameter 'newSize' when calling proveConsistency(Async)");
        }

        return proveConsistencyCall(oldSize, newSize, proctorVersion, _callback);

    }

    /**
     * Proof that a history of one size begins with that of another
     * For sizes up to that of the checkpoint, the old one at least 1 and at most the new one.
     * @param oldSize Size of the older history. (required)
     * @param newSize Size of the newer history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ConsistencyProof
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ConsistencyProof proveConsistency(@javax.annotation.Nonnull String oldSize, @javax.annotation.Nonnull String newSize, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<ConsistencyProof> localVarResp = proveConsistencyWithHttpInfo(oldSize, newSize, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Proof that a history of one size begins with that of another
     * For sizes up to that of the checkpoint, the old one at least 1 and at most the new one.
     * @param oldSize Size of the older history. (required)
     * @param newSize Size of the newer history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;ConsistencyProof&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<ConsistencyProof> proveConsistencyWithHttpInfo(@javax.annotation.Nonnull String oldSize, @javax.annotation.Nonnull String newSize, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = proveConsistencyValidateBeforeCall(oldSize, newSize, proctorVersion, null);
        Type localVarReturnType = new TypeToken<ConsistencyProof>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Proof that a history of one size begins with that of another (asynchronously)
     * For sizes up to that of the checkpoint, the old one at least 1 and at most the new one.
     * @param oldSize Size of the older history. (required)
     * @param newSize Size of the newer history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call proveConsistencyAsync(@javax.annotation.Nonnull String oldSize, @javax.annotation.Nonnull String newSize, @javax.annotation.Nullable String proctorVersion, final ApiCallback<ConsistencyProof> _callback) throws ApiException {

        okhttp3.Call localVarCall = proveConsistencyValidateBeforeCall(oldSize, newSize, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<ConsistencyProof>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for proveInclusion
     * @param leafIndex Index of the leaf, from 0. (required)
     * @param treeSize Size of the history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call proveInclusionCall(@javax.annotation.Nonnull String leafIndex, @javax.annotation.Nonnull String treeSize, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/history/inclusion";

        List<Pair> localVarQueryParams = new ArrayList<Pair>();
        List<Pair> localVarCollectionQueryParams = new ArrayList<Pair>();
        Map<String, String> localVarHeaderParams = new HashMap<String, String>();
        Map<String, String> localVarCookieParams = new HashMap<String, String>();
        Map<String, Object> localVarFormParams = new HashMap<String, Object>();

        if (leafIndex != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("leaf_index", leafIndex));
        }

        if (treeSize != null) {
            localVarQueryParams.addAll(localVarApiClient.parameterToPair("tree_size", treeSize));
        }

        final String[] localVarAccepts = {
            "application/json",
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
        return localVarApiClient.buildCall(basePath, localVarPath, "GET", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call proveInclusionValidateBeforeCall(@javax.annotation.Nonnull String leafIndex, @javax.annotation.Nonnull String treeSize, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'leafIndex' is set
        if (leafIndex == null) {
            throw new ApiException("Missing the required parameter 'leafIndex' when calling proveInclusion(Async)");
        }

        // verify the required parameter 'treeSize' is set
        if (treeSize == null) {
            throw new ApiException("Missing the required parameter 'treeSize' when calling proveInclusion(Async)");
        }

        return proveInclusionCall(leafIndex, treeSize, proctorVersion, _callback);

    }

    /**
     * Proof that a leaf stands in the history of a size
     * For a size up to that of the checkpoint and a leaf below it.
     * @param leafIndex Index of the leaf, from 0. (required)
     * @param treeSize Size of the history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return InclusionProof
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public InclusionProof proveInclusion(@javax.annotation.Nonnull String leafIndex, @javax.annotation.Nonnull String treeSize, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<InclusionProof> localVarResp = proveInclusionWithHttpInfo(leafIndex, treeSize, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Proof that a leaf stands in the history of a size
     * For a size up to that of the checkpoint and a leaf below it.
     * @param leafIndex Index of the leaf, from 0. (required)
     * @param treeSize Size of the history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;InclusionProof&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<InclusionProof> proveInclusionWithHttpInfo(@javax.annotation.Nonnull String leafIndex, @javax.annotation.Nonnull String treeSize, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = proveInclusionValidateBeforeCall(leafIndex, treeSize, proctorVersion, null);
        Type localVarReturnType = new TypeToken<InclusionProof>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Proof that a leaf stands in the history of a size (asynchronously)
     * For a size up to that of the checkpoint and a leaf below it.
     * @param leafIndex Index of the leaf, from 0. (required)
     * @param treeSize Size of the history. (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The proof. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call proveInclusionAsync(@javax.annotation.Nonnull String leafIndex, @javax.annotation.Nonnull String treeSize, @javax.annotation.Nullable String proctorVersion, final ApiCallback<InclusionProof> _callback) throws ApiException {

        okhttp3.Call localVarCall = proveInclusionValidateBeforeCall(leafIndex, treeSize, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<InclusionProof>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for publishEntry
     * @param runId  (required)
     * @param publishEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 201 </td><td> The entry, which is new. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call publishEntryCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull PublishEntry publishEntry, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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

        Object localVarPostBody = publishEntry;

        // create path and map variables
        String localVarPath = "/v1/runs/{run_id}/entry"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

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
        return localVarApiClient.buildCall(basePath, localVarPath, "PUT", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call publishEntryValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull PublishEntry publishEntry, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling publishEntry(Async)");
        }

        // verify the required parameter 'publishEntry' is set
        if (publishEntry == null) {
            throw new ApiException("Missing the required parameter 'publishEntry' when calling publishEntry(Async)");
        }

        return publishEntryCall(runId, publishEntry, proctorVersion, _callback);

    }

    /**
     * Publish a completed run on the leaderboard, or change what its entry says
     * A run has one entry. A repeat with the same body changes nothing; with another body it replaces the description, which has the defaults for what is left out. The score follows from the run and never changes. How often is bounded (BRD-001). Offered with the profile &#x60;board&#x60;, as are the operations on entries, rankings and history.
     * @param runId  (required)
     * @param publishEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return BoardEntry
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 201 </td><td> The entry, which is new. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public BoardEntry publishEntry(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull PublishEntry publishEntry, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<BoardEntry> localVarResp = publishEntryWithHttpInfo(runId, publishEntry, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Publish a completed run on the leaderboard, or change what its entry says
     * A run has one entry. A repeat with the same body changes nothing; with another body it replaces the description, which has the defaults for what is left out. The score follows from the run and never changes. How often is bounded (BRD-001). Offered with the profile &#x60;board&#x60;, as are the operations on entries, rankings and history.
     * @param runId  (required)
     * @param publishEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;BoardEntry&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 201 </td><td> The entry, which is new. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<BoardEntry> publishEntryWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull PublishEntry publishEntry, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = publishEntryValidateBeforeCall(runId, publishEntry, proctorVersion, null);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Publish a completed run on the leaderboard, or change what its entry says (asynchronously)
     * A run has one entry. A repeat with the same body changes nothing; with another body it replaces the description, which has the defaults for what is left out. The score follows from the run and never changes. How often is bounded (BRD-001). Offered with the profile &#x60;board&#x60;, as are the operations on entries, rankings and history.
     * @param runId  (required)
     * @param publishEntry  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 201 </td><td> The entry, which is new. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call publishEntryAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull PublishEntry publishEntry, @javax.annotation.Nullable String proctorVersion, final ApiCallback<BoardEntry> _callback) throws ApiException {

        okhttp3.Call localVarCall = publishEntryValidateBeforeCall(runId, publishEntry, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for resumeRun
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call resumeRunCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/runs/{run_id}/resume"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

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
    private okhttp3.Call resumeRunValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling resumeRun(Async)");
        }

        return resumeRunCall(runId, proctorVersion, _callback);

    }

    /**
     * Go on with the episodes that have no score yet
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Run
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Run resumeRun(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Run> localVarResp = resumeRunWithHttpInfo(runId, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Go on with the episodes that have no score yet
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Run&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Run> resumeRunWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = resumeRunValidateBeforeCall(runId, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Go on with the episodes that have no score yet (asynchronously)
     *
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call resumeRunAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Run> _callback) throws ApiException {

        okhttp3.Call localVarCall = resumeRunValidateBeforeCall(runId, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for stopRun
     * @param runId  (required)
     * @param stopRun  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call stopRunCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull StopRun stopRun, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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

        Object localVarPostBody = stopRun;

        // create path and map variables
        String localVarPath = "/v1/runs/{run_id}/stop"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

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
    private okhttp3.Call stopRunValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull StopRun stopRun, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling stopRun(Async)");
        }

        // verify the required parameter 'stopRun' is set
        if (stopRun == null) {
            throw new ApiException("Missing the required parameter 'stopRun' when calling stopRun(Async)");
        }

        return stopRunCall(runId, stopRun, proctorVersion, _callback);

    }

    /**
     * Stop now (abort) or after the episodes in play (drain)
     *
     * @param runId  (required)
     * @param stopRun  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Run
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Run stopRun(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull StopRun stopRun, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Run> localVarResp = stopRunWithHttpInfo(runId, stopRun, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Stop now (abort) or after the episodes in play (drain)
     *
     * @param runId  (required)
     * @param stopRun  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Run&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Run> stopRunWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull StopRun stopRun, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = stopRunValidateBeforeCall(runId, stopRun, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Stop now (abort) or after the episodes in play (drain) (asynchronously)
     *
     * @param runId  (required)
     * @param stopRun  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The run as it is now. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call stopRunAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nonnull StopRun stopRun, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Run> _callback) throws ApiException {

        okhttp3.Call localVarCall = stopRunValidateBeforeCall(runId, stopRun, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for submitRun
     * @param submitRun  (required)
     * @param idempotencyKey Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 201 </td><td> The run exists (or existed already under this Idempotency-Key). </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call submitRunCall(@javax.annotation.Nonnull SubmitRun submitRun, @javax.annotation.Nullable String idempotencyKey, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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

        Object localVarPostBody = submitRun;

        // create path and map variables
        String localVarPath = "/v1/runs";

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

        if (idempotencyKey != null) {
            localVarHeaderParams.put("Idempotency-Key", localVarApiClient.parameterToString(idempotencyKey));
        }


        if (proctorVersion != null) {
            localVarHeaderParams.put("Proctor-Version", localVarApiClient.parameterToString(proctorVersion));
        }


        String[] localVarAuthNames = new String[] { "bearer" };
        return localVarApiClient.buildCall(basePath, localVarPath, "POST", localVarQueryParams, localVarCollectionQueryParams, localVarPostBody, localVarHeaderParams, localVarCookieParams, localVarFormParams, localVarAuthNames, _callback);
    }

    @SuppressWarnings("rawtypes")
    private okhttp3.Call submitRunValidateBeforeCall(@javax.annotation.Nonnull SubmitRun submitRun, @javax.annotation.Nullable String idempotencyKey, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'submitRun' is set
        if (submitRun == null) {
            throw new ApiException("Missing the required parameter 'submitRun' when calling submitRun(Async)");
        }

        return submitRunCall(submitRun, idempotencyKey, proctorVersion, _callback);

    }

    /**
     * Ask for one evaluation of one policy on one benchmark
     *
     * @param submitRun  (required)
     * @param idempotencyKey Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return Run
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 201 </td><td> The run exists (or existed already under this Idempotency-Key). </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public Run submitRun(@javax.annotation.Nonnull SubmitRun submitRun, @javax.annotation.Nullable String idempotencyKey, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<Run> localVarResp = submitRunWithHttpInfo(submitRun, idempotencyKey, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Ask for one evaluation of one policy on one benchmark
     *
     * @param submitRun  (required)
     * @param idempotencyKey Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;Run&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 201 </td><td> The run exists (or existed already under this Idempotency-Key). </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<Run> submitRunWithHttpInfo(@javax.annotation.Nonnull SubmitRun submitRun, @javax.annotation.Nullable String idempotencyKey, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = submitRunValidateBeforeCall(submitRun, idempotencyKey, proctorVersion, null);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Ask for one evaluation of one policy on one benchmark (asynchronously)
     *
     * @param submitRun  (required)
     * @param idempotencyKey Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with &#x60;invalid_request&#x60; (ERR-014). (optional)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 201 </td><td> The run exists (or existed already under this Idempotency-Key). </td><td>  * Proctor-Version -  <br>  * Location - The import. <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call submitRunAsync(@javax.annotation.Nonnull SubmitRun submitRun, @javax.annotation.Nullable String idempotencyKey, @javax.annotation.Nullable String proctorVersion, final ApiCallback<Run> _callback) throws ApiException {

        okhttp3.Call localVarCall = submitRunValidateBeforeCall(submitRun, idempotencyKey, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<Run>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
    /**
     * Build call for withdrawEntry
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback Callback for upload/download progress
     * @return Call to execute
     * @throws ApiException If fail to serialize the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, withdrawn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call withdrawEntryCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
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
        String localVarPath = "/v1/runs/{run_id}/entry"
            .replace("{" + "run_id" + "}", localVarApiClient.escapeString(runId.toString()));

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
    private okhttp3.Call withdrawEntryValidateBeforeCall(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback _callback) throws ApiException {
        // verify the required parameter 'runId' is set
        if (runId == null) {
            throw new ApiException("Missing the required parameter 'runId' when calling withdrawEntry(Async)");
        }

        return withdrawEntryCall(runId, proctorVersion, _callback);

    }

    /**
     * Take the entry of a run off the leaderboard, for good
     * A withdrawn entry has no rank and is in no list; &#x60;get_entry&#x60; and the history go on to show it. A repeat changes nothing.
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return BoardEntry
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, withdrawn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public BoardEntry withdrawEntry(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        ApiResponse<BoardEntry> localVarResp = withdrawEntryWithHttpInfo(runId, proctorVersion);
        return localVarResp.getData();
    }

    /**
     * Take the entry of a run off the leaderboard, for good
     * A withdrawn entry has no rank and is in no list; &#x60;get_entry&#x60; and the history go on to show it. A repeat changes nothing.
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @return ApiResponse&lt;BoardEntry&gt;
     * @throws ApiException If fail to call the API, e.g. server error or cannot deserialize the response body
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, withdrawn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public ApiResponse<BoardEntry> withdrawEntryWithHttpInfo(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion) throws ApiException {
        okhttp3.Call localVarCall = withdrawEntryValidateBeforeCall(runId, proctorVersion, null);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        return localVarApiClient.execute(localVarCall, localVarReturnType);
    }

    /**
     * Take the entry of a run off the leaderboard, for good (asynchronously)
     * A withdrawn entry has no rank and is in no list; &#x60;get_entry&#x60; and the history go on to show it. A repeat changes nothing.
     * @param runId  (required)
     * @param proctorVersion The protocol version the caller was written for. (optional)
     * @param _callback The callback to be executed when the API call finishes
     * @return The request call
     * @throws ApiException If fail to process the API call, e.g. serializing the request body object
     * @http.response.details
     <table border="1">
       <caption>Response Details</caption>
        <tr><td> Status Code </td><td> Description </td><td> Response Headers </td></tr>
        <tr><td> 200 </td><td> The entry, withdrawn. </td><td>  * Proctor-Version -  <br>  </td></tr>
        <tr><td> 4XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
        <tr><td> 5XX </td><td> Refused; &#x60;code&#x60; says why (see x-problems). </td><td>  * Proctor-Version -  <br>  * Retry-After -  <br>  </td></tr>
     </table>
     */
    public okhttp3.Call withdrawEntryAsync(@javax.annotation.Nonnull String runId, @javax.annotation.Nullable String proctorVersion, final ApiCallback<BoardEntry> _callback) throws ApiException {

        okhttp3.Call localVarCall = withdrawEntryValidateBeforeCall(runId, proctorVersion, _callback);
        Type localVarReturnType = new TypeToken<BoardEntry>(){}.getType();
        localVarApiClient.executeAsync(localVarCall, localVarReturnType, _callback);
        return localVarCall;
    }
}
