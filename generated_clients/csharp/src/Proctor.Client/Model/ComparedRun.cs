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
    /// One run beside the baseline. A pair is an episode that both have scored.
    /// </summary>
    [DataContract(Name = "ComparedRun")]
    public partial class ComparedRun : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ComparedRun" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ComparedRun()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ComparedRun" /> class.
        /// </summary>
        /// <param name="runId">runId (required).</param>
        /// <param name="complete">Both runs have scored every episode. (required).</param>
        /// <param name="release">Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance. (required).</param>
        /// <param name="paired">Number of pairs. (required).</param>
        /// <param name="baselineMean">Mean score of the baseline over the pairs. (required).</param>
        /// <param name="mean">Mean score of the run over the pairs. (required).</param>
        /// <param name="difference">Baseline minus run: positive when the run is worse. (required).</param>
        /// <param name="wins">Pairs in which the run alone succeeds. (required).</param>
        /// <param name="losses">Pairs in which the baseline alone succeeds. (required).</param>
        /// <param name="ties">Pairs in which both succeed or neither does. (required).</param>
        /// <param name="pValue">McNemar&#39;s exact test, two-sided. (required).</param>
        /// <param name="byTask">Task → the pairs of its episodes. (required).</param>
        public ComparedRun(string runId = default, bool complete = default, bool release = default, int paired = default, double? baselineMean = default, double? mean = default, double? difference = default, int wins = default, int losses = default, int ties = default, double pValue = default, Dictionary<string, ComparedTask> byTask = default)
        {
            // to ensure "runId" is required (not null)
            if (runId == null)
            {
                throw new ArgumentNullException("runId is a required property for ComparedRun and cannot be null");
            }
            this.RunId = runId;
            this.Complete = complete;
            this.Release = release;
            this.Paired = paired;
            // to ensure "baselineMean" is required (not null)
            if (baselineMean == null)
            {
                throw new ArgumentNullException("baselineMean is a required property for ComparedRun and cannot be null");
            }
            this.BaselineMean = baselineMean;
            // to ensure "mean" is required (not null)
            if (mean == null)
            {
                throw new ArgumentNullException("mean is a required property for ComparedRun and cannot be null");
            }
            this.Mean = mean;
            // to ensure "difference" is required (not null)
            if (difference == null)
            {
                throw new ArgumentNullException("difference is a required property for ComparedRun and cannot be null");
            }
            this.Difference = difference;
            this.Wins = wins;
            this.Losses = losses;
            this.Ties = ties;
            this.PValue = pValue;
            // to ensure "byTask" is required (not null)
            if (byTask == null)
            {
                throw new ArgumentNullException("byTask is a required property for ComparedRun and cannot be null");
            }
            this.ByTask = byTask;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets RunId
        /// </summary>
        [DataMember(Name = "run_id", IsRequired = true, EmitDefaultValue = true)]
        public string RunId { get; set; }

        /// <summary>
        /// Both runs have scored every episode.
        /// </summary>
        /// <value>Both runs have scored every episode.</value>
        [DataMember(Name = "complete", IsRequired = true, EmitDefaultValue = true)]
        public bool Complete { get; set; }

        /// <summary>
        /// Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
        /// </summary>
        /// <value>Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.</value>
        [DataMember(Name = "release", IsRequired = true, EmitDefaultValue = true)]
        public bool Release { get; set; }

        /// <summary>
        /// Number of pairs.
        /// </summary>
        /// <value>Number of pairs.</value>
        [DataMember(Name = "paired", IsRequired = true, EmitDefaultValue = true)]
        public int Paired { get; set; }

        /// <summary>
        /// Mean score of the baseline over the pairs.
        /// </summary>
        /// <value>Mean score of the baseline over the pairs.</value>
        [DataMember(Name = "baseline_mean", IsRequired = true, EmitDefaultValue = true)]
        public double? BaselineMean { get; set; }

        /// <summary>
        /// Mean score of the run over the pairs.
        /// </summary>
        /// <value>Mean score of the run over the pairs.</value>
        [DataMember(Name = "mean", IsRequired = true, EmitDefaultValue = true)]
        public double? Mean { get; set; }

        /// <summary>
        /// Baseline minus run: positive when the run is worse.
        /// </summary>
        /// <value>Baseline minus run: positive when the run is worse.</value>
        [DataMember(Name = "difference", IsRequired = true, EmitDefaultValue = true)]
        public double? Difference { get; set; }

        /// <summary>
        /// Pairs in which the run alone succeeds.
        /// </summary>
        /// <value>Pairs in which the run alone succeeds.</value>
        [DataMember(Name = "wins", IsRequired = true, EmitDefaultValue = true)]
        public int Wins { get; set; }

        /// <summary>
        /// Pairs in which the baseline alone succeeds.
        /// </summary>
        /// <value>Pairs in which the baseline alone succeeds.</value>
        [DataMember(Name = "losses", IsRequired = true, EmitDefaultValue = true)]
        public int Losses { get; set; }

        /// <summary>
        /// Pairs in which both succeed or neither does.
        /// </summary>
        /// <value>Pairs in which both succeed or neither does.</value>
        [DataMember(Name = "ties", IsRequired = true, EmitDefaultValue = true)]
        public int Ties { get; set; }

        /// <summary>
        /// McNemar&#39;s exact test, two-sided.
        /// </summary>
        /// <value>McNemar&#39;s exact test, two-sided.</value>
        [DataMember(Name = "p_value", IsRequired = true, EmitDefaultValue = true)]
        public double PValue { get; set; }

        /// <summary>
        /// Task → the pairs of its episodes.
        /// </summary>
        /// <value>Task → the pairs of its episodes.</value>
        [DataMember(Name = "by_task", IsRequired = true, EmitDefaultValue = true)]
        public Dictionary<string, ComparedTask> ByTask { get; set; }

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
            sb.Append("class ComparedRun {\n");
            sb.Append("  RunId: ").Append(RunId).Append("\n");
            sb.Append("  Complete: ").Append(Complete).Append("\n");
            sb.Append("  Release: ").Append(Release).Append("\n");
            sb.Append("  Paired: ").Append(Paired).Append("\n");
            sb.Append("  BaselineMean: ").Append(BaselineMean).Append("\n");
            sb.Append("  Mean: ").Append(Mean).Append("\n");
            sb.Append("  Difference: ").Append(Difference).Append("\n");
            sb.Append("  Wins: ").Append(Wins).Append("\n");
            sb.Append("  Losses: ").Append(Losses).Append("\n");
            sb.Append("  Ties: ").Append(Ties).Append("\n");
            sb.Append("  PValue: ").Append(PValue).Append("\n");
            sb.Append("  ByTask: ").Append(ByTask).Append("\n");
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
            // Paired (int) minimum
            if (this.Paired < (int)0)
            {
                yield return new ValidationResult("Invalid value for Paired, must be a value greater than or equal to 0.", new [] { "Paired" });
            }

            // Wins (int) minimum
            if (this.Wins < (int)0)
            {
                yield return new ValidationResult("Invalid value for Wins, must be a value greater than or equal to 0.", new [] { "Wins" });
            }

            // Losses (int) minimum
            if (this.Losses < (int)0)
            {
                yield return new ValidationResult("Invalid value for Losses, must be a value greater than or equal to 0.", new [] { "Losses" });
            }

            // Ties (int) minimum
            if (this.Ties < (int)0)
            {
                yield return new ValidationResult("Invalid value for Ties, must be a value greater than or equal to 0.", new [] { "Ties" });
            }

            // PValue (double) maximum
            if (this.PValue > (double)1)
            {
                yield return new ValidationResult("Invalid value for PValue, must be a value less than or equal to 1.", new [] { "PValue" });
            }

            // PValue (double) minimum
            if (this.PValue < (double)0)
            {
                yield return new ValidationResult("Invalid value for PValue, must be a value greater than or equal to 0.", new [] { "PValue" });
            }

            yield break;
        }
    }

}
