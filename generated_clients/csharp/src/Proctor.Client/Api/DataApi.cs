/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */


using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.Linq;
using System.Net;
using System.Net.Http;
using System.Net.Mime;
using Proctor.Client.Client;
using Proctor.Client.Model;

namespace Proctor.Client.Api
{

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public interface IDataApiSync : IApiAccessor
    {
        #region Synchronous Operations
        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Turn</returns>
        Turn AttachWorker(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default);

        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Turn</returns>
        ApiResponse<Turn> AttachWorkerWithHttpInfo(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default);
        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns></returns>
        void DetachWorker(string runId, string workerId, string sessionId, string? proctorVersion = default);

        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Object(void)</returns>
        ApiResponse<Object> DetachWorkerWithHttpInfo(string runId, string workerId, string sessionId, string? proctorVersion = default);
        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Lease</returns>
        Lease Heartbeat(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default);

        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Lease</returns>
        ApiResponse<Lease> HeartbeatWithHttpInfo(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default);
        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Turn</returns>
        Turn Predict(string runId, string workerId, Predict predict, string? proctorVersion = default);

        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Turn</returns>
        ApiResponse<Turn> PredictWithHttpInfo(string runId, string workerId, Predict predict, string? proctorVersion = default);
        #endregion Synchronous Operations
    }

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public interface IDataApiAsync : IApiAccessor
    {
        #region Asynchronous Operations
        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Turn</returns>
        System.Threading.Tasks.Task<Turn> AttachWorkerAsync(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Turn)</returns>
        System.Threading.Tasks.Task<ApiResponse<Turn>> AttachWorkerWithHttpInfoAsync(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of void</returns>
        System.Threading.Tasks.Task DetachWorkerAsync(string runId, string workerId, string sessionId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse</returns>
        System.Threading.Tasks.Task<ApiResponse<Object>> DetachWorkerWithHttpInfoAsync(string runId, string workerId, string sessionId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Lease</returns>
        System.Threading.Tasks.Task<Lease> HeartbeatAsync(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Lease)</returns>
        System.Threading.Tasks.Task<ApiResponse<Lease>> HeartbeatWithHttpInfoAsync(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Turn</returns>
        System.Threading.Tasks.Task<Turn> PredictAsync(string runId, string workerId, Predict predict, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);

        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <remarks>
        ///
        /// </remarks>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Turn)</returns>
        System.Threading.Tasks.Task<ApiResponse<Turn>> PredictWithHttpInfoAsync(string runId, string workerId, Predict predict, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default);
        #endregion Asynchronous Operations
    }

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public interface IDataApi : IDataApiSync, IDataApiAsync
    {

    }

    /// <summary>
    /// Represents a collection of functions to interact with the API endpoints
    /// </summary>
    public partial class DataApi : IDisposable, IDataApi
    {
        private Proctor.Client.Client.ExceptionFactory _exceptionFactory = (name, response) => null;

        /// <summary>
        /// Initializes a new instance of the <see cref="DataApi"/> class.
        /// **IMPORTANT** This will also create an instance of HttpClient, which is less than ideal.
        /// It's better to reuse the <see href="https://docs.microsoft.com/en-us/dotnet/architecture/microservices/implement-resilient-applications/use-httpclientfactory-to-implement-resilient-http-requests#issues-with-the-original-httpclient-class-available-in-net">HttpClient and HttpClientHandler</see>.
        /// </summary>
        /// <returns></returns>
        public DataApi() : this((string)null)
        {
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="DataApi"/> class.
        /// **IMPORTANT** This will also create an instance of HttpClient, which is less than ideal.
        /// It's better to reuse the <see href="https://docs.microsoft.com/en-us/dotnet/architecture/microservices/implement-resilient-applications/use-httpclientfactory-to-implement-resilient-http-requests#issues-with-the-original-httpclient-class-available-in-net">HttpClient and HttpClientHandler</see>.
        /// </summary>
        /// <param name="basePath">The target service's base path in URL format.</param>
        /// <exception cref="ArgumentException"></exception>
        /// <returns></returns>
        public DataApi(string basePath)
        {
            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                new Proctor.Client.Client.Configuration { BasePath = basePath }
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(this.Configuration.BasePath);
            this.Client =  this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            this.ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="DataApi"/> class using Configuration object.
        /// **IMPORTANT** This will also create an instance of HttpClient, which is less than ideal.
        /// It's better to reuse the <see href="https://docs.microsoft.com/en-us/dotnet/architecture/microservices/implement-resilient-applications/use-httpclientfactory-to-implement-resilient-http-requests#issues-with-the-original-httpclient-class-available-in-net">HttpClient and HttpClientHandler</see>.
        /// </summary>
        /// <param name="configuration">An instance of Configuration.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <returns></returns>
        public DataApi(Proctor.Client.Client.Configuration configuration)
        {
            if (configuration == null) throw new ArgumentNullException("configuration");

            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                configuration
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(this.Configuration.BasePath);
            this.Client = this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="DataApi"/> class.
        /// </summary>
        /// <param name="client">An instance of HttpClient.</param>
        /// <param name="handler">An optional instance of HttpClientHandler that is used by HttpClient.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <returns></returns>
        /// <remarks>
        /// Some configuration settings will not be applied without passing an HttpClientHandler.
        /// The features affected are: Setting and Retrieving Cookies, Client Certificates, Proxy settings.
        /// </remarks>
        public DataApi(HttpClient client, HttpClientHandler handler = null) : this(client, (string)null, handler)
        {
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="DataApi"/> class.
        /// </summary>
        /// <param name="client">An instance of HttpClient.</param>
        /// <param name="basePath">The target service's base path in URL format.</param>
        /// <param name="handler">An optional instance of HttpClientHandler that is used by HttpClient.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <exception cref="ArgumentException"></exception>
        /// <returns></returns>
        /// <remarks>
        /// Some configuration settings will not be applied without passing an HttpClientHandler.
        /// The features affected are: Setting and Retrieving Cookies, Client Certificates, Proxy settings.
        /// </remarks>
        public DataApi(HttpClient client, string basePath, HttpClientHandler handler = null)
        {
            if (client == null) throw new ArgumentNullException("client");

            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                new Proctor.Client.Client.Configuration { BasePath = basePath }
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(client, this.Configuration.BasePath, handler);
            this.Client =  this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            this.ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="DataApi"/> class using Configuration object.
        /// </summary>
        /// <param name="client">An instance of HttpClient.</param>
        /// <param name="configuration">An instance of Configuration.</param>
        /// <param name="handler">An optional instance of HttpClientHandler that is used by HttpClient.</param>
        /// <exception cref="ArgumentNullException"></exception>
        /// <returns></returns>
        /// <remarks>
        /// Some configuration settings will not be applied without passing an HttpClientHandler.
        /// The features affected are: Setting and Retrieving Cookies, Client Certificates, Proxy settings.
        /// </remarks>
        public DataApi(HttpClient client, Proctor.Client.Client.Configuration configuration, HttpClientHandler handler = null)
        {
            if (configuration == null) throw new ArgumentNullException("configuration");
            if (client == null) throw new ArgumentNullException("client");

            this.Configuration = Proctor.Client.Client.Configuration.MergeConfigurations(
                Proctor.Client.Client.GlobalConfiguration.Instance,
                configuration
            );
            this.ApiClient = new Proctor.Client.Client.ApiClient(client, this.Configuration.BasePath, handler);
            this.Client = this.ApiClient;
            this.AsynchronousClient = this.ApiClient;
            ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Initializes a new instance of the <see cref="DataApi"/> class
        /// using a Configuration object and client instance.
        /// </summary>
        /// <param name="client">The client interface for synchronous API access.</param>
        /// <param name="asyncClient">The client interface for asynchronous API access.</param>
        /// <param name="configuration">The configuration object.</param>
        /// <exception cref="ArgumentNullException"></exception>
        public DataApi(Proctor.Client.Client.ISynchronousClient client, Proctor.Client.Client.IAsynchronousClient asyncClient, Proctor.Client.Client.IReadableConfiguration configuration)
        {
            if (client == null) throw new ArgumentNullException("client");
            if (asyncClient == null) throw new ArgumentNullException("asyncClient");
            if (configuration == null) throw new ArgumentNullException("configuration");

            this.Client = client;
            this.AsynchronousClient = asyncClient;
            this.Configuration = configuration;
            this.ExceptionFactory = Proctor.Client.Client.Configuration.DefaultExceptionFactory;
        }

        /// <summary>
        /// Disposes resources if they were created by us
        /// </summary>
        public void Dispose()
        {
            this.ApiClient?.Dispose();
        }

        /// <summary>
        /// Holds the ApiClient if created
        /// </summary>
        public Proctor.Client.Client.ApiClient ApiClient { get; set; } = null;

        /// <summary>
        /// The client for accessing this underlying API asynchronously.
        /// </summary>
        public Proctor.Client.Client.IAsynchronousClient AsynchronousClient { get; set; }

        /// <summary>
        /// The client for accessing this underlying API synchronously.
        /// </summary>
        public Proctor.Client.Client.ISynchronousClient Client { get; set; }

        /// <summary>
        /// Gets the base path of the API client.
        /// </summary>
        /// <value>The base path</value>
        public string GetBasePath()
        {
            return this.Configuration.BasePath;
        }

        /// <summary>
        /// Gets or sets the configuration object
        /// </summary>
        /// <value>An instance of the Configuration</value>
        public Proctor.Client.Client.IReadableConfiguration Configuration { get; set; }

        /// <summary>
        /// Provides a factory method hook for the creation of exceptions.
        /// </summary>
        public Proctor.Client.Client.ExceptionFactory ExceptionFactory
        {
            get
            {
                if (_exceptionFactory != null && _exceptionFactory.GetInvocationList().Length > 1)
                {
                    throw new InvalidOperationException("Multicast delegate for ExceptionFactory is unsupported.");
                }
                return _exceptionFactory;
            }
            set { _exceptionFactory = value; }
        }

        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Turn</returns>
        public Turn AttachWorker(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Turn> localVarResponse = AttachWorkerWithHttpInfo(runId, workerId, attachWorker, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Turn</returns>
        public Proctor.Client.Client.ApiResponse<Turn> AttachWorkerWithHttpInfo(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->AttachWorker");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->AttachWorker");

            // verify the required parameter 'attachWorker' is set
            if (attachWorker == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'attachWorker' when calling DataApi->AttachWorker");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json",
                "application/msgpack"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/msgpack",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = attachWorker;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Put<Turn>("/v1/runs/{run_id}/workers/{worker_id}", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("AttachWorker", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Turn</returns>
        public async System.Threading.Tasks.Task<Turn> AttachWorkerAsync(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Turn> localVarResponse = await AttachWorkerWithHttpInfoAsync(runId, workerId, attachWorker, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Open a session for a worker and get its turn 0
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="attachWorker"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Turn)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Turn>> AttachWorkerWithHttpInfoAsync(string runId, string workerId, AttachWorker attachWorker, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->AttachWorker");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->AttachWorker");

            // verify the required parameter 'attachWorker' is set
            if (attachWorker == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'attachWorker' when calling DataApi->AttachWorker");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json",
                "application/msgpack"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/msgpack",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = attachWorker;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.PutAsync<Turn>("/v1/runs/{run_id}/workers/{worker_id}", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("AttachWorker", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns></returns>
        public void DetachWorker(string runId, string workerId, string sessionId, string? proctorVersion = default)
        {
            DetachWorkerWithHttpInfo(runId, workerId, sessionId, proctorVersion);
        }

        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Object(void)</returns>
        public Proctor.Client.Client.ApiResponse<Object> DetachWorkerWithHttpInfo(string runId, string workerId, string sessionId, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->DetachWorker");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->DetachWorker");

            // verify the required parameter 'sessionId' is set
            if (sessionId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'sessionId' when calling DataApi->DetachWorker");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "session_id", sessionId));
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Delete<Object>("/v1/runs/{run_id}/workers/{worker_id}", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("DetachWorker", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of void</returns>
        public async System.Threading.Tasks.Task DetachWorkerAsync(string runId, string workerId, string sessionId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            await DetachWorkerWithHttpInfoAsync(runId, workerId, sessionId, proctorVersion, cancellationToken).ConfigureAwait(false);
        }

        /// <summary>
        /// Close a session and free its slot at once
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="sessionId">The session to close.</param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Object>> DetachWorkerWithHttpInfoAsync(string runId, string workerId, string sessionId, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->DetachWorker");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->DetachWorker");

            // verify the required parameter 'sessionId' is set
            if (sessionId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'sessionId' when calling DataApi->DetachWorker");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            localVarRequestOptions.QueryParameters.Add(Proctor.Client.Client.ClientUtils.ParameterToMultiMap("", "session_id", sessionId));
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.DeleteAsync<Object>("/v1/runs/{run_id}/workers/{worker_id}", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("DetachWorker", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Lease</returns>
        public Lease Heartbeat(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Lease> localVarResponse = HeartbeatWithHttpInfo(runId, workerId, heartbeat, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Lease</returns>
        public Proctor.Client.Client.ApiResponse<Lease> HeartbeatWithHttpInfo(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->Heartbeat");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->Heartbeat");

            // verify the required parameter 'heartbeat' is set
            if (heartbeat == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'heartbeat' when calling DataApi->Heartbeat");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = heartbeat;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Post<Lease>("/v1/runs/{run_id}/workers/{worker_id}/heartbeat", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("Heartbeat", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Lease</returns>
        public async System.Threading.Tasks.Task<Lease> HeartbeatAsync(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Lease> localVarResponse = await HeartbeatWithHttpInfoAsync(runId, workerId, heartbeat, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// Extend the lease while the policy thinks
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="heartbeat"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Lease)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Lease>> HeartbeatWithHttpInfoAsync(string runId, string workerId, Heartbeat heartbeat, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->Heartbeat");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->Heartbeat");

            // verify the required parameter 'heartbeat' is set
            if (heartbeat == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'heartbeat' when calling DataApi->Heartbeat");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = heartbeat;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.PostAsync<Lease>("/v1/runs/{run_id}/workers/{worker_id}/heartbeat", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("Heartbeat", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>Turn</returns>
        public Turn Predict(string runId, string workerId, Predict predict, string? proctorVersion = default)
        {
            Proctor.Client.Client.ApiResponse<Turn> localVarResponse = PredictWithHttpInfo(runId, workerId, predict, proctorVersion);
            return localVarResponse.Data;
        }

        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <returns>ApiResponse of Turn</returns>
        public Proctor.Client.Client.ApiResponse<Turn> PredictWithHttpInfo(string runId, string workerId, Predict predict, string? proctorVersion = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->Predict");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->Predict");

            // verify the required parameter 'predict' is set
            if (predict == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'predict' when calling DataApi->Predict");

            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json",
                "application/msgpack"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/msgpack",
                "application/problem+json"
            };

            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = predict;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request
            var localVarResponse = this.Client.Post<Turn>("/v1/runs/{run_id}/workers/{worker_id}/predict", localVarRequestOptions, this.Configuration);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("Predict", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of Turn</returns>
        public async System.Threading.Tasks.Task<Turn> PredictAsync(string runId, string workerId, Predict predict, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            Proctor.Client.Client.ApiResponse<Turn> localVarResponse = await PredictWithHttpInfoAsync(runId, workerId, predict, proctorVersion, cancellationToken).ConfigureAwait(false);
            return localVarResponse.Data;
        }

        /// <summary>
        /// A chunk of actions in, the next observation out
        /// </summary>
        /// <exception cref="Proctor.Client.Client.ApiException">Thrown when fails to make API call</exception>
        /// <param name="runId"></param>
        /// <param name="workerId">Chosen by the client; stable over re-attachments.</param>
        /// <param name="predict"></param>
        /// <param name="proctorVersion">The protocol version the caller was written for. (optional)</param>
        /// <param name="cancellationToken">Cancellation Token to cancel the request.</param>
        /// <returns>Task of ApiResponse (Turn)</returns>
        public async System.Threading.Tasks.Task<Proctor.Client.Client.ApiResponse<Turn>> PredictWithHttpInfoAsync(string runId, string workerId, Predict predict, string? proctorVersion = default, System.Threading.CancellationToken cancellationToken = default)
        {
            // verify the required parameter 'runId' is set
            if (runId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'runId' when calling DataApi->Predict");

            // verify the required parameter 'workerId' is set
            if (workerId == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'workerId' when calling DataApi->Predict");

            // verify the required parameter 'predict' is set
            if (predict == null)
                throw new Proctor.Client.Client.ApiException(400, "Missing required parameter 'predict' when calling DataApi->Predict");


            Proctor.Client.Client.RequestOptions localVarRequestOptions = new Proctor.Client.Client.RequestOptions();

            string[] _contentTypes = new string[] {
                "application/json",
                "application/msgpack"
            };

            // to determine the Accept header
            string[] _accepts = new string[] {
                "application/json",
                "application/msgpack",
                "application/problem+json"
            };


            var localVarContentType = Proctor.Client.Client.ClientUtils.SelectHeaderContentType(_contentTypes);
            if (localVarContentType != null) localVarRequestOptions.HeaderParameters.Add("Content-Type", localVarContentType);

            var localVarAccept = Proctor.Client.Client.ClientUtils.SelectHeaderAccept(_accepts);
            if (localVarAccept != null) localVarRequestOptions.HeaderParameters.Add("Accept", localVarAccept);

            localVarRequestOptions.PathParameters.Add("run_id", Proctor.Client.Client.ClientUtils.ParameterToString(runId)); // path parameter
            localVarRequestOptions.PathParameters.Add("worker_id", Proctor.Client.Client.ClientUtils.ParameterToString(workerId)); // path parameter
            if (proctorVersion != null)
            {
                localVarRequestOptions.HeaderParameters.Add("Proctor-Version", Proctor.Client.Client.ClientUtils.ParameterToString(proctorVersion)); // header parameter
            }
            localVarRequestOptions.Data = predict;

            // authentication (bearer) required
            // bearer authentication required
            if (!string.IsNullOrEmpty(this.Configuration.AccessToken) && !localVarRequestOptions.HeaderParameters.ContainsKey("Authorization"))
            {
                localVarRequestOptions.HeaderParameters.Add("Authorization", "Bearer " + this.Configuration.AccessToken);
            }

            // make the HTTP request

            var localVarResponse = await this.AsynchronousClient.PostAsync<Turn>("/v1/runs/{run_id}/workers/{worker_id}/predict", localVarRequestOptions, this.Configuration, cancellationToken).ConfigureAwait(false);

            if (this.ExceptionFactory != null)
            {
                Exception _exception = this.ExceptionFactory("Predict", localVarResponse);
                if (_exception != null) throw _exception;
            }

            return localVarResponse;
        }

    }
}
