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
    /// An attempt begins; whatever the policy remembers of this session is over.
    /// </summary>
    [DataContract(Name = "ResetPolicy")]
    public partial class ResetPolicy : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ResetPolicy" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ResetPolicy()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ResetPolicy" /> class.
        /// </summary>
        /// <param name="sessionId">sessionId (required).</param>
        /// <param name="runId">runId.</param>
        /// <param name="benchmark">benchmark (required).</param>
        /// <param name="episode">episode (required).</param>
        public ResetPolicy(string sessionId = default, string runId = default, Benchmark benchmark = default, EpisodeView episode = default)
        {
            // to ensure "sessionId" is required (not null)
            if (sessionId == null)
            {
                throw new ArgumentNullException("sessionId is a required property for ResetPolicy and cannot be null");
            }
            this.SessionId = sessionId;
            // to ensure "benchmark" is required (not null)
            if (benchmark == null)
            {
                throw new ArgumentNullException("benchmark is a required property for ResetPolicy and cannot be null");
            }
            this.Benchmark = benchmark;
            // to ensure "episode" is required (not null)
            if (episode == null)
            {
                throw new ArgumentNullException("episode is a required property for ResetPolicy and cannot be null");
            }
            this.Episode = episode;
            this.RunId = runId;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets SessionId
        /// </summary>
        [DataMember(Name = "session_id", IsRequired = true, EmitDefaultValue = true)]
        public string SessionId { get; set; }

        /// <summary>
        /// Gets or Sets RunId
        /// </summary>
        [DataMember(Name = "run_id", EmitDefaultValue = false)]
        public string RunId { get; set; }

        /// <summary>
        /// Gets or Sets Benchmark
        /// </summary>
        [DataMember(Name = "benchmark", IsRequired = true, EmitDefaultValue = true)]
        public Benchmark Benchmark { get; set; }

        /// <summary>
        /// Gets or Sets Episode
        /// </summary>
        [DataMember(Name = "episode", IsRequired = true, EmitDefaultValue = true)]
        public EpisodeView Episode { get; set; }

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
            sb.Append("class ResetPolicy {\n");
            sb.Append("  SessionId: ").Append(SessionId).Append("\n");
            sb.Append("  RunId: ").Append(RunId).Append("\n");
            sb.Append("  Benchmark: ").Append(Benchmark).Append("\n");
            sb.Append("  Episode: ").Append(Episode).Append("\n");
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
            // SessionId (string) maxLength
            if (this.SessionId != null && this.SessionId.Length > 128)
            {
                yield return new ValidationResult("Invalid value for SessionId, length must be less than 128.", new [] { "SessionId" });
            }

            // SessionId (string) minLength
            if (this.SessionId != null && this.SessionId.Length < 1)
            {
                yield return new ValidationResult("Invalid value for SessionId, length must be greater than 1.", new [] { "SessionId" });
            }

            yield break;
        }
    }

}
