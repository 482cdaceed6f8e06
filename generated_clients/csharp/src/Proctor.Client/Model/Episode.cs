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
    /// Episode
    /// </summary>
    [DataContract(Name = "Episode")]
    public partial class Episode : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets Status
        /// </summary>
        [DataMember(Name = "status", IsRequired = true, EmitDefaultValue = true)]
        public EpisodeStatus Status { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="Episode" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Episode()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Episode" /> class.
        /// </summary>
        /// <param name="episodeId">episodeId (required).</param>
        /// <param name="index">index (required).</param>
        /// <param name="task">task (required).</param>
        /// <param name="split">split (required).</param>
        /// <param name="status">status (required).</param>
        /// <param name="attempt">The current or next attempt. (required).</param>
        /// <param name="faults">faults (required).</param>
        /// <param name="policyFault">In a run with mode &#x60;push&#x60;: what the policy did wrong when it last ended an attempt of this episode..</param>
        /// <param name="result">result.</param>
        public Episode(string episodeId = default, int index = default, string task = default, string split = default, EpisodeStatus status = default, int attempt = default, int faults = default, string policyFault = default, EpisodeResult result = default)
        {
            // to ensure "episodeId" is required (not null)
            if (episodeId == null)
            {
                throw new ArgumentNullException("episodeId is a required property for Episode and cannot be null");
            }
            this.EpisodeId = episodeId;
            this.Index = index;
            // to ensure "task" is required (not null)
            if (task == null)
            {
                throw new ArgumentNullException("task is a required property for Episode and cannot be null");
            }
            this.Task = task;
            // to ensure "split" is required (not null)
            if (split == null)
            {
                throw new ArgumentNullException("split is a required property for Episode and cannot be null");
            }
            this.Split = split;
            this.Status = status;
            this.Attempt = attempt;
            this.Faults = faults;
            this.PolicyFault = policyFault;
            this.Result = result;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets EpisodeId
        /// </summary>
        [DataMember(Name = "episode_id", IsRequired = true, EmitDefaultValue = true)]
        public string EpisodeId { get; set; }

        /// <summary>
        /// Gets or Sets Index
        /// </summary>
        [DataMember(Name = "index", IsRequired = true, EmitDefaultValue = true)]
        public int Index { get; set; }

        /// <summary>
        /// Gets or Sets Task
        /// </summary>
        [DataMember(Name = "task", IsRequired = true, EmitDefaultValue = true)]
        public string Task { get; set; }

        /// <summary>
        /// Gets or Sets Split
        /// </summary>
        [DataMember(Name = "split", IsRequired = true, EmitDefaultValue = true)]
        public string Split { get; set; }

        /// <summary>
        /// The current or next attempt.
        /// </summary>
        /// <value>The current or next attempt.</value>
        [DataMember(Name = "attempt", IsRequired = true, EmitDefaultValue = true)]
        public int Attempt { get; set; }

        /// <summary>
        /// Gets or Sets Faults
        /// </summary>
        [DataMember(Name = "faults", IsRequired = true, EmitDefaultValue = true)]
        public int Faults { get; set; }

        /// <summary>
        /// In a run with mode &#x60;push&#x60;: what the policy did wrong when it last ended an attempt of this episode.
        /// </summary>
        /// <value>In a run with mode &#x60;push&#x60;: what the policy did wrong when it last ended an attempt of this episode.</value>
        [DataMember(Name = "policy_fault", EmitDefaultValue = false)]
        public string PolicyFault { get; set; }

        /// <summary>
        /// Gets or Sets Result
        /// </summary>
        [DataMember(Name = "result", EmitDefaultValue = false)]
        public EpisodeResult Result { get; set; }

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
            sb.Append("class Episode {\n");
            sb.Append("  EpisodeId: ").Append(EpisodeId).Append("\n");
            sb.Append("  Index: ").Append(Index).Append("\n");
            sb.Append("  Task: ").Append(Task).Append("\n");
            sb.Append("  Split: ").Append(Split).Append("\n");
            sb.Append("  Status: ").Append(Status).Append("\n");
            sb.Append("  Attempt: ").Append(Attempt).Append("\n");
            sb.Append("  Faults: ").Append(Faults).Append("\n");
            sb.Append("  PolicyFault: ").Append(PolicyFault).Append("\n");
            sb.Append("  Result: ").Append(Result).Append("\n");
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
            // Index (int) minimum
            if (this.Index < (int)0)
            {
                yield return new ValidationResult("Invalid value for Index, must be a value greater than or equal to 0.", new [] { "Index" });
            }

            // Attempt (int) minimum
            if (this.Attempt < (int)1)
            {
                yield return new ValidationResult("Invalid value for Attempt, must be a value greater than or equal to 1.", new [] { "Attempt" });
            }

            // Faults (int) minimum
            if (this.Faults < (int)0)
            {
                yield return new ValidationResult("Invalid value for Faults, must be a value greater than or equal to 0.", new [] { "Faults" });
            }

            yield break;
        }
    }

}
