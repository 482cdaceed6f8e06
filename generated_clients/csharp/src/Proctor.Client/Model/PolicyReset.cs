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
    /// The policy is ready for this attempt and no other.
    /// </summary>
    [DataContract(Name = "PolicyReset")]
    public partial class PolicyReset : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyReset" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected PolicyReset()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyReset" /> class.
        /// </summary>
        /// <param name="sessionId">sessionId (required).</param>
        /// <param name="episodeId">episodeId (required).</param>
        /// <param name="attempt">attempt (required).</param>
        public PolicyReset(string sessionId = default, string episodeId = default, int attempt = default)
        {
            // to ensure "sessionId" is required (not null)
            if (sessionId == null)
            {
                throw new ArgumentNullException("sessionId is a required property for PolicyReset and cannot be null");
            }
            this.SessionId = sessionId;
            // to ensure "episodeId" is required (not null)
            if (episodeId == null)
            {
                throw new ArgumentNullException("episodeId is a required property for PolicyReset and cannot be null");
            }
            this.EpisodeId = episodeId;
            this.Attempt = attempt;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets SessionId
        /// </summary>
        [DataMember(Name = "session_id", IsRequired = true, EmitDefaultValue = true)]
        public string SessionId { get; set; }

        /// <summary>
        /// Gets or Sets EpisodeId
        /// </summary>
        [DataMember(Name = "episode_id", IsRequired = true, EmitDefaultValue = true)]
        public string EpisodeId { get; set; }

        /// <summary>
        /// Gets or Sets Attempt
        /// </summary>
        [DataMember(Name = "attempt", IsRequired = true, EmitDefaultValue = true)]
        public int Attempt { get; set; }

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
            sb.Append("class PolicyReset {\n");
            sb.Append("  SessionId: ").Append(SessionId).Append("\n");
            sb.Append("  EpisodeId: ").Append(EpisodeId).Append("\n");
            sb.Append("  Attempt: ").Append(Attempt).Append("\n");
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
            // Attempt (int) minimum
            if (this.Attempt < (int)1)
            {
                yield return new ValidationResult("Invalid value for Attempt, must be a value greater than or equal to 1.", new [] { "Attempt" });
            }

            yield break;
        }
    }

}
