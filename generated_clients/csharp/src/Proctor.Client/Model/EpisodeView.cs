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
    /// The episode that the observation belongs to.
    /// </summary>
    [DataContract(Name = "EpisodeView")]
    public partial class EpisodeView : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="EpisodeView" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected EpisodeView()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="EpisodeView" /> class.
        /// </summary>
        /// <param name="episodeId">episodeId (required).</param>
        /// <param name="index">Position in the manifest. (required).</param>
        /// <param name="task">task (required).</param>
        /// <param name="instruction">instruction (required).</param>
        /// <param name="attempt">attempt (required).</param>
        /// <param name="step">step (required).</param>
        /// <param name="maxSteps">maxSteps (required).</param>
        public EpisodeView(string episodeId = default, int index = default, string task = default, string instruction = default, int attempt = default, int step = default, int maxSteps = default)
        {
            // to ensure "episodeId" is required (not null)
            if (episodeId == null)
            {
                throw new ArgumentNullException("episodeId is a required property for EpisodeView and cannot be null");
            }
            this.EpisodeId = episodeId;
            this.Index = index;
            // to ensure "task" is required (not null)
            if (task == null)
            {
                throw new ArgumentNullException("task is a required property for EpisodeView and cannot be null");
            }
            this.Task = task;
            // to ensure "instruction" is required (not null)
            if (instruction == null)
            {
                throw new ArgumentNullException("instruction is a required property for EpisodeView and cannot be null");
            }
            this.Instruction = instruction;
            this.Attempt = attempt;
            this.Step = step;
            this.MaxSteps = maxSteps;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets EpisodeId
        /// </summary>
        [DataMember(Name = "episode_id", IsRequired = true, EmitDefaultValue = true)]
        public string EpisodeId { get; set; }

        /// <summary>
        /// Position in the manifest.
        /// </summary>
        /// <value>Position in the manifest.</value>
        [DataMember(Name = "index", IsRequired = true, EmitDefaultValue = true)]
        public int Index { get; set; }

        /// <summary>
        /// Gets or Sets Task
        /// </summary>
        [DataMember(Name = "task", IsRequired = true, EmitDefaultValue = true)]
        public string Task { get; set; }

        /// <summary>
        /// Gets or Sets Instruction
        /// </summary>
        [DataMember(Name = "instruction", IsRequired = true, EmitDefaultValue = true)]
        public string Instruction { get; set; }

        /// <summary>
        /// Gets or Sets Attempt
        /// </summary>
        [DataMember(Name = "attempt", IsRequired = true, EmitDefaultValue = true)]
        public int Attempt { get; set; }

        /// <summary>
        /// Gets or Sets Step
        /// </summary>
        [DataMember(Name = "step", IsRequired = true, EmitDefaultValue = true)]
        public int Step { get; set; }

        /// <summary>
        /// Gets or Sets MaxSteps
        /// </summary>
        [DataMember(Name = "max_steps", IsRequired = true, EmitDefaultValue = true)]
        public int MaxSteps { get; set; }

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
            sb.Append("class EpisodeView {\n");
            sb.Append("  EpisodeId: ").Append(EpisodeId).Append("\n");
            sb.Append("  Index: ").Append(Index).Append("\n");
            sb.Append("  Task: ").Append(Task).Append("\n");
            sb.Append("  Instruction: ").Append(Instruction).Append("\n");
            sb.Append("  Attempt: ").Append(Attempt).Append("\n");
            sb.Append("  Step: ").Append(Step).Append("\n");
            sb.Append("  MaxSteps: ").Append(MaxSteps).Append("\n");
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

            // Step (int) minimum
            if (this.Step < (int)0)
            {
                yield return new ValidationResult("Invalid value for Step, must be a value greater than or equal to 0.", new [] { "Step" });
            }

            // MaxSteps (int) minimum
            if (this.MaxSteps < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxSteps, must be a value greater than or equal to 1.", new [] { "MaxSteps" });
            }

            yield break;
        }
    }

}
