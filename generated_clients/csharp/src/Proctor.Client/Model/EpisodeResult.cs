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
    /// EpisodeResult
    /// </summary>
    [DataContract(Name = "EpisodeResult")]
    public partial class EpisodeResult : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets Outcome
        /// </summary>
        [DataMember(Name = "outcome", IsRequired = true, EmitDefaultValue = true)]
        public Outcome Outcome { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="EpisodeResult" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected EpisodeResult()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="EpisodeResult" /> class.
        /// </summary>
        /// <param name="episodeId">episodeId (required).</param>
        /// <param name="index">index (required).</param>
        /// <param name="task">task (required).</param>
        /// <param name="split">split (required).</param>
        /// <param name="seed">seed (required).</param>
        /// <param name="attempt">attempt (required).</param>
        /// <param name="faults">faults (required).</param>
        /// <param name="outcome">outcome (required).</param>
        /// <param name="score">score (required).</param>
        /// <param name="steps">steps (required).</param>
        /// <param name="terminated">terminated (required).</param>
        /// <param name="truncated">truncated (required).</param>
        /// <param name="thinkS">Time between turns that the policy took. (required).</param>
        /// <param name="finishedAt">finishedAt (required).</param>
        public EpisodeResult(string episodeId = default, int index = default, string task = default, string split = default, long seed = default, int attempt = default, int faults = default, Outcome outcome = default, double score = default, int steps = default, bool terminated = default, bool truncated = default, double thinkS = default, DateTime finishedAt = default)
        {
            // to ensure "episodeId" is required (not null)
            if (episodeId == null)
            {
                throw new ArgumentNullException("episodeId is a required property for EpisodeResult and cannot be null");
            }
            this.EpisodeId = episodeId;
            this.Index = index;
            // to ensure "task" is required (not null)
            if (task == null)
            {
                throw new ArgumentNullException("task is a required property for EpisodeResult and cannot be null");
            }
            this.Task = task;
            // to ensure "split" is required (not null)
            if (split == null)
            {
                throw new ArgumentNullException("split is a required property for EpisodeResult and cannot be null");
            }
            this.Split = split;
            this.Seed = seed;
            this.Attempt = attempt;
            this.Faults = faults;
            this.Outcome = outcome;
            this.Score = score;
            this.Steps = steps;
            this.Terminated = terminated;
            this.Truncated = truncated;
            this.ThinkS = thinkS;
            this.FinishedAt = finishedAt;
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
        /// Gets or Sets Seed
        /// </summary>
        [DataMember(Name = "seed", IsRequired = true, EmitDefaultValue = true)]
        public long Seed { get; set; }

        /// <summary>
        /// Gets or Sets Attempt
        /// </summary>
        [DataMember(Name = "attempt", IsRequired = true, EmitDefaultValue = true)]
        public int Attempt { get; set; }

        /// <summary>
        /// Gets or Sets Faults
        /// </summary>
        [DataMember(Name = "faults", IsRequired = true, EmitDefaultValue = true)]
        public int Faults { get; set; }

        /// <summary>
        /// Gets or Sets Score
        /// </summary>
        [DataMember(Name = "score", IsRequired = true, EmitDefaultValue = true)]
        public double Score { get; set; }

        /// <summary>
        /// Gets or Sets Steps
        /// </summary>
        [DataMember(Name = "steps", IsRequired = true, EmitDefaultValue = true)]
        public int Steps { get; set; }

        /// <summary>
        /// Gets or Sets Terminated
        /// </summary>
        [DataMember(Name = "terminated", IsRequired = true, EmitDefaultValue = true)]
        public bool Terminated { get; set; }

        /// <summary>
        /// Gets or Sets Truncated
        /// </summary>
        [DataMember(Name = "truncated", IsRequired = true, EmitDefaultValue = true)]
        public bool Truncated { get; set; }

        /// <summary>
        /// Time between turns that the policy took.
        /// </summary>
        /// <value>Time between turns that the policy took.</value>
        [DataMember(Name = "think_s", IsRequired = true, EmitDefaultValue = true)]
        public double ThinkS { get; set; }

        /// <summary>
        /// Gets or Sets FinishedAt
        /// </summary>
        [DataMember(Name = "finished_at", IsRequired = true, EmitDefaultValue = true)]
        public DateTime FinishedAt { get; set; }

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
            sb.Append("class EpisodeResult {\n");
            sb.Append("  EpisodeId: ").Append(EpisodeId).Append("\n");
            sb.Append("  Index: ").Append(Index).Append("\n");
            sb.Append("  Task: ").Append(Task).Append("\n");
            sb.Append("  Split: ").Append(Split).Append("\n");
            sb.Append("  Seed: ").Append(Seed).Append("\n");
            sb.Append("  Attempt: ").Append(Attempt).Append("\n");
            sb.Append("  Faults: ").Append(Faults).Append("\n");
            sb.Append("  Outcome: ").Append(Outcome).Append("\n");
            sb.Append("  Score: ").Append(Score).Append("\n");
            sb.Append("  Steps: ").Append(Steps).Append("\n");
            sb.Append("  Terminated: ").Append(Terminated).Append("\n");
            sb.Append("  Truncated: ").Append(Truncated).Append("\n");
            sb.Append("  ThinkS: ").Append(ThinkS).Append("\n");
            sb.Append("  FinishedAt: ").Append(FinishedAt).Append("\n");
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

            // Seed (long) maximum
            if (this.Seed > (long)9007199254740991)
            {
                yield return new ValidationResult("Invalid value for Seed, must be a value less than or equal to 9007199254740991.", new [] { "Seed" });
            }

            // Seed (long) minimum
            if (this.Seed < (long)0)
            {
                yield return new ValidationResult("Invalid value for Seed, must be a value greater than or equal to 0.", new [] { "Seed" });
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

            // Score (double) maximum
            if (this.Score > (double)1)
            {
                yield return new ValidationResult("Invalid value for Score, must be a value less than or equal to 1.", new [] { "Score" });
            }

            // Score (double) minimum
            if (this.Score < (double)0)
            {
                yield return new ValidationResult("Invalid value for Score, must be a value greater than or equal to 0.", new [] { "Score" });
            }

            // Steps (int) minimum
            if (this.Steps < (int)0)
            {
                yield return new ValidationResult("Invalid value for Steps, must be a value greater than or equal to 0.", new [] { "Steps" });
            }

            // ThinkS (double) minimum
            if (this.ThinkS < (double)0)
            {
                yield return new ValidationResult("Invalid value for ThinkS, must be a value greater than or equal to 0.", new [] { "ThinkS" });
            }

            yield break;
        }
    }

}
