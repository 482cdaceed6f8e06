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
    /// See scoring.md for every number here.
    /// </summary>
    [DataContract(Name = "Score")]
    public partial class Score : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets State
        /// </summary>
        [DataMember(Name = "state", IsRequired = true, EmitDefaultValue = true)]
        public RunState State { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="Score" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Score()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Score" /> class.
        /// </summary>
        /// <param name="runId">runId (required).</param>
        /// <param name="benchmarkId">benchmarkId (required).</param>
        /// <param name="manifestSha256">The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. (required).</param>
        /// <param name="state">state (required).</param>
        /// <param name="complete">complete (required).</param>
        /// <param name="varScore">Null until complete. (required).</param>
        /// <param name="scoreLow">scoreLow (required).</param>
        /// <param name="scoreHigh">scoreHigh (required).</param>
        /// <param name="counts">counts (required).</param>
        /// <param name="successRate">successRate (required).</param>
        /// <param name="successInterval">successInterval (required).</param>
        /// <param name="mean">Mean over the scored episodes. (required).</param>
        /// <param name="meanInterval">meanInterval (required).</param>
        /// <param name="byTask">byTask (required).</param>
        /// <param name="bySplit">bySplit (required).</param>
        public Score(string runId = default, string benchmarkId = default, string manifestSha256 = default, RunState state = default, bool complete = default, double? varScore = default, double scoreLow = default, double scoreHigh = default, OutcomeCounts counts = default, double? successRate = default, Interval successInterval = default, double? mean = default, Interval meanInterval = default, Dictionary<string, GroupScore> byTask = default, Dictionary<string, GroupScore> bySplit = default)
        {
            // to ensure "runId" is required (not null)
            if (runId == null)
            {
                throw new ArgumentNullException("runId is a required property for Score and cannot be null");
            }
            this.RunId = runId;
            // to ensure "benchmarkId" is required (not null)
            if (benchmarkId == null)
            {
                throw new ArgumentNullException("benchmarkId is a required property for Score and cannot be null");
            }
            this.BenchmarkId = benchmarkId;
            // to ensure "manifestSha256" is required (not null)
            if (manifestSha256 == null)
            {
                throw new ArgumentNullException("manifestSha256 is a required property for Score and cannot be null");
            }
            this.ManifestSha256 = manifestSha256;
            this.State = state;
            this.Complete = complete;
            // to ensure "varScore" is required (not null)
            if (varScore == null)
            {
                throw new ArgumentNullException("varScore is a required property for Score and cannot be null");
            }
            this.VarScore = varScore;
            this.ScoreLow = scoreLow;
            this.ScoreHigh = scoreHigh;
            // to ensure "counts" is required (not null)
            if (counts == null)
            {
                throw new ArgumentNullException("counts is a required property for Score and cannot be null");
            }
            this.Counts = counts;
            // to ensure "successRate" is required (not null)
            if (successRate == null)
            {
                throw new ArgumentNullException("successRate is a required property for Score and cannot be null");
            }
            this.SuccessRate = successRate;
            // to ensure "successInterval" is required (not null)
            if (successInterval == null)
            {
                throw new ArgumentNullException("successInterval is a required property for Score and cannot be null");
            }
            this.SuccessInterval = successInterval;
            // to ensure "mean" is required (not null)
            if (mean == null)
            {
                throw new ArgumentNullException("mean is a required property for Score and cannot be null");
            }
            this.Mean = mean;
            // to ensure "meanInterval" is required (not null)
            if (meanInterval == null)
            {
                throw new ArgumentNullException("meanInterval is a required property for Score and cannot be null");
            }
            this.MeanInterval = meanInterval;
            // to ensure "byTask" is required (not null)
            if (byTask == null)
            {
                throw new ArgumentNullException("byTask is a required property for Score and cannot be null");
            }
            this.ByTask = byTask;
            // to ensure "bySplit" is required (not null)
            if (bySplit == null)
            {
                throw new ArgumentNullException("bySplit is a required property for Score and cannot be null");
            }
            this.BySplit = bySplit;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets RunId
        /// </summary>
        [DataMember(Name = "run_id", IsRequired = true, EmitDefaultValue = true)]
        public string RunId { get; set; }

        /// <summary>
        /// Gets or Sets BenchmarkId
        /// </summary>
        [DataMember(Name = "benchmark_id", IsRequired = true, EmitDefaultValue = true)]
        public string BenchmarkId { get; set; }

        /// <summary>
        /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
        /// </summary>
        /// <value>The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.</value>
        [DataMember(Name = "manifest_sha256", IsRequired = true, EmitDefaultValue = true)]
        public string ManifestSha256 { get; set; }

        /// <summary>
        /// Gets or Sets Complete
        /// </summary>
        [DataMember(Name = "complete", IsRequired = true, EmitDefaultValue = true)]
        public bool Complete { get; set; }

        /// <summary>
        /// Null until complete.
        /// </summary>
        /// <value>Null until complete.</value>
        [DataMember(Name = "score", IsRequired = true, EmitDefaultValue = true)]
        public double? VarScore { get; set; }

        /// <summary>
        /// Gets or Sets ScoreLow
        /// </summary>
        [DataMember(Name = "score_low", IsRequired = true, EmitDefaultValue = true)]
        public double ScoreLow { get; set; }

        /// <summary>
        /// Gets or Sets ScoreHigh
        /// </summary>
        [DataMember(Name = "score_high", IsRequired = true, EmitDefaultValue = true)]
        public double ScoreHigh { get; set; }

        /// <summary>
        /// Gets or Sets Counts
        /// </summary>
        [DataMember(Name = "counts", IsRequired = true, EmitDefaultValue = true)]
        public OutcomeCounts Counts { get; set; }

        /// <summary>
        /// Gets or Sets SuccessRate
        /// </summary>
        [DataMember(Name = "success_rate", IsRequired = true, EmitDefaultValue = true)]
        public double? SuccessRate { get; set; }

        /// <summary>
        /// Gets or Sets SuccessInterval
        /// </summary>
        [DataMember(Name = "success_interval", IsRequired = true, EmitDefaultValue = true)]
        public Interval SuccessInterval { get; set; }

        /// <summary>
        /// Mean over the scored episodes.
        /// </summary>
        /// <value>Mean over the scored episodes.</value>
        [DataMember(Name = "mean", IsRequired = true, EmitDefaultValue = true)]
        public double? Mean { get; set; }

        /// <summary>
        /// Gets or Sets MeanInterval
        /// </summary>
        [DataMember(Name = "mean_interval", IsRequired = true, EmitDefaultValue = true)]
        public Interval MeanInterval { get; set; }

        /// <summary>
        /// Gets or Sets ByTask
        /// </summary>
        [DataMember(Name = "by_task", IsRequired = true, EmitDefaultValue = true)]
        public Dictionary<string, GroupScore> ByTask { get; set; }

        /// <summary>
        /// Gets or Sets BySplit
        /// </summary>
        [DataMember(Name = "by_split", IsRequired = true, EmitDefaultValue = true)]
        public Dictionary<string, GroupScore> BySplit { get; set; }

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
            sb.Append("class Score {\n");
            sb.Append("  RunId: ").Append(RunId).Append("\n");
            sb.Append("  BenchmarkId: ").Append(BenchmarkId).Append("\n");
            sb.Append("  ManifestSha256: ").Append(ManifestSha256).Append("\n");
            sb.Append("  State: ").Append(State).Append("\n");
            sb.Append("  Complete: ").Append(Complete).Append("\n");
            sb.Append("  VarScore: ").Append(VarScore).Append("\n");
            sb.Append("  ScoreLow: ").Append(ScoreLow).Append("\n");
            sb.Append("  ScoreHigh: ").Append(ScoreHigh).Append("\n");
            sb.Append("  Counts: ").Append(Counts).Append("\n");
            sb.Append("  SuccessRate: ").Append(SuccessRate).Append("\n");
            sb.Append("  SuccessInterval: ").Append(SuccessInterval).Append("\n");
            sb.Append("  Mean: ").Append(Mean).Append("\n");
            sb.Append("  MeanInterval: ").Append(MeanInterval).Append("\n");
            sb.Append("  ByTask: ").Append(ByTask).Append("\n");
            sb.Append("  BySplit: ").Append(BySplit).Append("\n");
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

            yield break;
        }
    }

}
