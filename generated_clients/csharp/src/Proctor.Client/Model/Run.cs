/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */


using System;
using System.Collections;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.Linq;
using System.IO;
using System.Runtime.Serialization;
using System.Text;
using System.Text.RegularExpressions;
using Newtonsoft.Json;
using Newtonsoft.Json.Converters;
using Newtonsoft.Json.Linq;
using System.ComponentModel.DataAnnotations;
using FileParameter = Proctor.Client.Client.FileParameter;
using OpenAPIDateConverter = Proctor.Client.Client.OpenAPIDateConverter;

namespace Proctor.Client.Model
{
    /// <summary>
    /// Run
    /// </summary>
    [DataContract(Name = "Run")]
    public partial class Run : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets State
        /// </summary>
        [DataMember(Name = "state", IsRequired = true, EmitDefaultValue = true)]
        public RunState State { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="Run" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Run()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Run" /> class.
        /// </summary>
        /// <param name="runId">runId (required).</param>
        /// <param name="state">state (required).</param>
        /// <param name="reason">Why the run is in this state, for people; never null when failed. (required).</param>
        /// <param name="retryable">Whether a failed run may be resumed; null in other states. (required).</param>
        /// <param name="benchmarkId">benchmarkId (required).</param>
        /// <param name="benchmarkVersion">benchmarkVersion (required).</param>
        /// <param name="manifestSha256">The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. (required).</param>
        /// <param name="policy">policy (required).</param>
        /// <param name="mode">A &#x60;RunMode&#x60;, or one of a later version; &#x60;pull&#x60; when absent..</param>
        /// <param name="policyServer">policyServer.</param>
        /// <param name="maxWorkers">maxWorkers (required).</param>
        /// <param name="idleTimeoutS">idleTimeoutS (required).</param>
        /// <param name="images">images (required).</param>
        /// <param name="endpoint">Base URL of the data plane for this run; the path of an operation is appended to it. (required).</param>
        /// <param name="queuePosition">1 is next; null unless queued. (required).</param>
        /// <param name="liveWorkers">liveWorkers (required).</param>
        /// <param name="progress">progress (required).</param>
        /// <param name="createdAt">createdAt (required).</param>
        /// <param name="updatedAt">updatedAt (required).</param>
        public Run(string runId = default, RunState state = default, string reason = default, bool? retryable = default, string benchmarkId = default, string benchmarkVersion = default, string manifestSha256 = default, PolicyInfo policy = default, string mode = default, PolicyServerView policyServer = default, int maxWorkers = default, double idleTimeoutS = default, ImageChoice images = default, string endpoint = default, int? queuePosition = default, int liveWorkers = default, Progress progress = default, DateTime createdAt = default, DateTime updatedAt = default)
        {
            // to ensure "runId" is required (not null)
            if (runId == null)
            {
                throw new ArgumentNullException("runId is a required property for Run and cannot be null");
            }
            this.RunId = runId;
            this.State = state;
            // to ensure "reason" is required (not null)
            if (reason == null)
            {
                throw new ArgumentNullException("reason is a required property for Run and cannot be null");
            }
            this.Reason = reason;
            // to ensure "retryable" is required (not null)
            if (retryable == null)
            {
                throw new ArgumentNullException("retryable is a required property for Run and cannot be null");
            }
            this.Retryable = retryable;
            // to ensure "benchmarkId" is required (not null)
            if (benchmarkId == null)
            {
                throw new ArgumentNullException("benchmarkId is a required property for Run and cannot be null");
            }
            this.BenchmarkId = benchmarkId;
            // to ensure "benchmarkVersion" is required (not null)
            if (benchmarkVersion == null)
            {
                throw new ArgumentNullException("benchmarkVersion is a required property for Run and cannot be null");
            }
            this.BenchmarkVersion = benchmarkVersion;
            // to ensure "manifestSha256" is required (not null)
            if (manifestSha256 == null)
            {
                throw new ArgumentNullException("manifestSha256 is a required property for Run and cannot be null");
            }
            this.ManifestSha256 = manifestSha256;
            // to ensure "policy" is required (not null)
            if (policy == null)
            {
                throw new ArgumentNullException("policy is a required property for Run and cannot be null");
            }
            this.Policy = policy;
            this.MaxWorkers = maxWorkers;
            this.IdleTimeoutS = idleTimeoutS;
            // to ensure "images" is required (not null)
            if (images == null)
            {
                throw new ArgumentNullException("images is a required property for Run and cannot be null");
            }
            this.Images = images;
            // to ensure "endpoint" is required (not null)
            if (endpoint == null)
            {
                throw new ArgumentNullException("endpoint is a required property for Run and cannot be null");
            }
            this.Endpoint = endpoint;
            // to ensure "queuePosition" is required (not null)
            if (queuePosition == null)
            {
                throw new ArgumentNullException("queuePosition is a required property for Run and cannot be null");
            }
            this.QueuePosition = queuePosition;
            this.LiveWorkers = liveWorkers;
            // to ensure "progress" is required (not null)
            if (progress == null)
            {
                throw new ArgumentNullException("progress is a required property for Run and cannot be null");
            }
            this.Progress = progress;
            this.CreatedAt = createdAt;
            this.UpdatedAt = updatedAt;
            this.Mode = mode;
            this.PolicyServer = policyServer;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets RunId
        /// </summary>
        [DataMember(Name = "run_id", IsRequired = true, EmitDefaultValue = true)]
        public string RunId { get; set; }

        /// <summary>
        /// Why the run is in this state, for people; never null when failed.
        /// </summary>
        /// <value>Why the run is in this state, for people; never null when failed.</value>
        [DataMember(Name = "reason", IsRequired = true, EmitDefaultValue = true)]
        public string Reason { get; set; }

        /// <summary>
        /// Whether a failed run may be resumed; null in other states.
        /// </summary>
        /// <value>Whether a failed run may be resumed; null in other states.</value>
        [DataMember(Name = "retryable", IsRequired = true, EmitDefaultValue = true)]
        public bool? Retryable { get; set; }

        /// <summary>
        /// Gets or Sets BenchmarkId
        /// </summary>
        [DataMember(Name = "benchmark_id", IsRequired = true, EmitDefaultValue = true)]
        public string BenchmarkId { get; set; }

        /// <summary>
        /// Gets or Sets BenchmarkVersion
        /// </summary>
        [DataMember(Name = "benchmark_version", IsRequired = true, EmitDefaultValue = true)]
        public string BenchmarkVersion { get; set; }

        /// <summary>
        /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
        /// </summary>
        /// <value>The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.</value>
        [DataMember(Name = "manifest_sha256", IsRequired = true, EmitDefaultValue = true)]
        public string ManifestSha256 { get; set; }

        /// <summary>
        /// Gets or Sets Policy
        /// </summary>
        [DataMember(Name = "policy", IsRequired = true, EmitDefaultValue = true)]
        public PolicyInfo Policy { get; set; }

        /// <summary>
        /// A &#x60;RunMode&#x60;, or one of a later version; &#x60;pull&#x60; when absent.
        /// </summary>
        /// <value>A &#x60;RunMode&#x60;, or one of a later version; &#x60;pull&#x60; when absent.</value>
        [DataMember(Name = "mode", EmitDefaultValue = false)]
        public string Mode { get; set; }

        /// <summary>
        /// Gets or Sets PolicyServer
        /// </summary>
        [DataMember(Name = "policy_server", EmitDefaultValue = false)]
        public PolicyServerView PolicyServer { get; set; }

        /// <summary>
        /// Gets or Sets MaxWorkers
        /// </summary>
        [DataMember(Name = "max_workers", IsRequired = true, EmitDefaultValue = true)]
        public int MaxWorkers { get; set; }

        /// <summary>
        /// Gets or Sets IdleTimeoutS
        /// </summary>
        [DataMember(Name = "idle_timeout_s", IsRequired = true, EmitDefaultValue = true)]
        public double IdleTimeoutS { get; set; }

        /// <summary>
        /// Gets or Sets Images
        /// </summary>
        [DataMember(Name = "images", IsRequired = true, EmitDefaultValue = true)]
        public ImageChoice Images { get; set; }

        /// <summary>
        /// Base URL of the data plane for this run; the path of an operation is appended to it.
        /// </summary>
        /// <value>Base URL of the data plane for this run; the path of an operation is appended to it.</value>
        [DataMember(Name = "endpoint", IsRequired = true, EmitDefaultValue = true)]
        public string Endpoint { get; set; }

        /// <summary>
        /// 1 is next; null unless queued.
        /// </summary>
        /// <value>1 is next; null unless queued.</value>
        [DataMember(Name = "queue_position", IsRequired = true, EmitDefaultValue = true)]
        public int? QueuePosition { get; set; }

        /// <summary>
        /// Gets or Sets LiveWorkers
        /// </summary>
        [DataMember(Name = "live_workers", IsRequired = true, EmitDefaultValue = true)]
        public int LiveWorkers { get; set; }

        /// <summary>
        /// Gets or Sets Progress
        /// </summary>
        [DataMember(Name = "progress", IsRequired = true, EmitDefaultValue = true)]
        public Progress Progress { get; set; }

        /// <summary>
        /// Gets or Sets CreatedAt
        /// </summary>
        [DataMember(Name = "created_at", IsRequired = true, EmitDefaultValue = true)]
        public DateTime CreatedAt { get; set; }

        /// <summary>
        /// Gets or Sets UpdatedAt
        /// </summary>
        [DataMember(Name = "updated_at", IsRequired = true, EmitDefaultValue = true)]
        public DateTime UpdatedAt { get; set; }

        /// <summary>
        /// Gets or Sets additional properties
        /// </summary>
        [JsonExtensionData]
        public IDictionary<string, object> AdditionalProperties { get; set; }

        /// <summary>
        /// Returns the string presentation of the object
        /// </summary>
        /// <returns>String presentation of the object</returns>
        public override string ToString()
        {
            StringBuilder sb = new StringBuilder();
            sb.Append("class Run {\n");
            sb.Append("  RunId: ").Append(RunId).Append("\n");
            sb.Append("  State: ").Append(State).Append("\n");
            sb.Append("  Reason: ").Append(Reason).Append("\n");
            sb.Append("  Retryable: ").Append(Retryable).Append("\n");
            sb.Append("  BenchmarkId: ").Append(BenchmarkId).Append("\n");
            sb.Append("  BenchmarkVersion: ").Append(BenchmarkVersion).Append("\n");
            sb.Append("  ManifestSha256: ").Append(ManifestSha256).Append("\n");
            sb.Append("  Policy: ").Append(Policy).Append("\n");
            sb.Append("  Mode: ").Append(Mode).Append("\n");
            sb.Append("  PolicyServer: ").Append(PolicyServer).Append("\n");
            sb.Append("  MaxWorkers: ").Append(MaxWorkers).Append("\n");
            sb.Append("  IdleTimeoutS: ").Append(IdleTimeoutS).Append("\n");
            sb.Append("  Images: ").Append(Images).Append("\n");
            sb.Append("  Endpoint: ").Append(Endpoint).Append("\n");
            sb.Append("  QueuePosition: ").Append(QueuePosition).Append("\n");
            sb.Append("  LiveWorkers: ").Append(LiveWorkers).Append("\n");
            sb.Append("  Progress: ").Append(Progress).Append("\n");
            sb.Append("  CreatedAt: ").Append(CreatedAt).Append("\n");
            sb.Append("  UpdatedAt: ").Append(UpdatedAt).Append("\n");
            sb.Append("  AdditionalProperties: ").Append(AdditionalProperties).Append("\n");
            sb.Append("}\n");
            return sb.ToString();
        }

        /// <summary>
        /// Returns the JSON string presentation of the object
        /// </summary>
        /// <returns>JSON string presentation of the object</returns>
        public virtual string ToJson()
        {
            return Newtonsoft.Json.JsonConvert.SerializeObject(this, Newtonsoft.Json.Formatting.Indented);
        }

        /// <summary>
        /// To validate all properties of the instance
        /// </summary>
        /// <param name="validationContext">Validation context</param>
        /// <returns>Validation Result</returns>
        IEnumerable<ValidationResult> IValidatableObject.Validate(ValidationContext validationContext)
        {
            if (this.ManifestSha256 != null) {
                // ManifestSha256 (string) pattern
                Regex regexManifestSha256 = new Regex(@"^[0-9a-f]{64}$", RegexOptions.CultureInvariant);
                if (!regexManifestSha256.Match(this.ManifestSha256).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for ManifestSha256, must match a pattern of " + regexManifestSha256, new [] { "ManifestSha256" });
                }
            }

            if (this.Mode != null) {
                // Mode (string) pattern
                Regex regexMode = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexMode.Match(this.Mode).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Mode, must match a pattern of " + regexMode, new [] { "Mode" });
                }
            }

            // LiveWorkers (int) minimum
            if (this.LiveWorkers < (int)0)
            {
                yield return new ValidationResult("Invalid value for LiveWorkers, must be a value greater than or equal to 0.", new [] { "LiveWorkers" });
            }

            yield break;
        }
    }

}
