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
    /// SubmitRun
    /// </summary>
    [DataContract(Name = "SubmitRun")]
    public partial class SubmitRun : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets Mode
        /// </summary>
        [DataMember(Name = "mode", EmitDefaultValue = false)]
        public RunMode? Mode { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="SubmitRun" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected SubmitRun()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="SubmitRun" /> class.
        /// </summary>
        /// <param name="benchmarkId">benchmarkId (required).</param>
        /// <param name="policy">policy (required).</param>
        /// <param name="maxWorkers">Most live workers wanted; the server&#39;s limit when absent..</param>
        /// <param name="idleTimeoutS">Lease of a session; the server&#39;s maximum when absent..</param>
        /// <param name="images">images.</param>
        /// <param name="options">options.</param>
        /// <param name="mode">mode.</param>
        /// <param name="policyServer">policyServer.</param>
        public SubmitRun(string benchmarkId = default, PolicyInfo policy = default, int maxWorkers = default, double idleTimeoutS = default, ImageChoice images = default, CalibrationOptions options = default, RunMode? mode = default, PolicyServer policyServer = default)
        {
            // to ensure "benchmarkId" is required (not null)
            if (benchmarkId == null)
            {
                throw new ArgumentNullException("benchmarkId is a required property for SubmitRun and cannot be null");
            }
            this.BenchmarkId = benchmarkId;
            // to ensure "policy" is required (not null)
            if (policy == null)
            {
                throw new ArgumentNullException("policy is a required property for SubmitRun and cannot be null");
            }
            this.Policy = policy;
            this.MaxWorkers = maxWorkers;
            this.IdleTimeoutS = idleTimeoutS;
            this.Images = images;
            this.Options = options;
            this.Mode = mode;
            this.PolicyServer = policyServer;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets BenchmarkId
        /// </summary>
        [DataMember(Name = "benchmark_id", IsRequired = true, EmitDefaultValue = true)]
        public string BenchmarkId { get; set; }

        /// <summary>
        /// Gets or Sets Policy
        /// </summary>
        [DataMember(Name = "policy", IsRequired = true, EmitDefaultValue = true)]
        public PolicyInfo Policy { get; set; }

        /// <summary>
        /// Most live workers wanted; the server&#39;s limit when absent.
        /// </summary>
        /// <value>Most live workers wanted; the server&#39;s limit when absent.</value>
        [DataMember(Name = "max_workers", EmitDefaultValue = false)]
        public int MaxWorkers { get; set; }

        /// <summary>
        /// Lease of a session; the server&#39;s maximum when absent.
        /// </summary>
        /// <value>Lease of a session; the server&#39;s maximum when absent.</value>
        [DataMember(Name = "idle_timeout_s", EmitDefaultValue = false)]
        public double IdleTimeoutS { get; set; }

        /// <summary>
        /// Gets or Sets Images
        /// </summary>
        [DataMember(Name = "images", EmitDefaultValue = false)]
        public ImageChoice Images { get; set; }

        /// <summary>
        /// Gets or Sets Options
        /// </summary>
        [DataMember(Name = "options", EmitDefaultValue = false)]
        public CalibrationOptions Options { get; set; }

        /// <summary>
        /// Gets or Sets PolicyServer
        /// </summary>
        [DataMember(Name = "policy_server", EmitDefaultValue = false)]
        public PolicyServer PolicyServer { get; set; }

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
            sb.Append("class SubmitRun {\n");
            sb.Append("  BenchmarkId: ").Append(BenchmarkId).Append("\n");
            sb.Append("  Policy: ").Append(Policy).Append("\n");
            sb.Append("  MaxWorkers: ").Append(MaxWorkers).Append("\n");
            sb.Append("  IdleTimeoutS: ").Append(IdleTimeoutS).Append("\n");
            sb.Append("  Images: ").Append(Images).Append("\n");
            sb.Append("  Options: ").Append(Options).Append("\n");
            sb.Append("  Mode: ").Append(Mode).Append("\n");
            sb.Append("  PolicyServer: ").Append(PolicyServer).Append("\n");
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
            if (this.BenchmarkId != null) {
                // BenchmarkId (string) pattern
                Regex regexBenchmarkId = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexBenchmarkId.Match(this.BenchmarkId).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for BenchmarkId, must match a pattern of " + regexBenchmarkId, new [] { "BenchmarkId" });
                }
            }

            // MaxWorkers (int) maximum
            if (this.MaxWorkers > (int)1024)
            {
                yield return new ValidationResult("Invalid value for MaxWorkers, must be a value less than or equal to 1024.", new [] { "MaxWorkers" });
            }

            // MaxWorkers (int) minimum
            if (this.MaxWorkers < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxWorkers, must be a value greater than or equal to 1.", new [] { "MaxWorkers" });
            }

            // IdleTimeoutS (double) maximum
            if (this.IdleTimeoutS > (double)86400)
            {
                yield return new ValidationResult("Invalid value for IdleTimeoutS, must be a value less than or equal to 86400.", new [] { "IdleTimeoutS" });
            }

            // IdleTimeoutS (double) minimum
            if (this.IdleTimeoutS < (double)1)
            {
                yield return new ValidationResult("Invalid value for IdleTimeoutS, must be a value greater than or equal to 1.", new [] { "IdleTimeoutS" });
            }

            yield break;
        }
    }

}
