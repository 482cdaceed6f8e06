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
    /// Everything about a benchmark that can change a score.
    /// </summary>
    [DataContract(Name = "Benchmark")]
    public partial class Benchmark : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Benchmark" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Benchmark()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Benchmark" /> class.
        /// </summary>
        /// <param name="benchmarkId">benchmarkId (required).</param>
        /// <param name="varVersion">varVersion (required).</param>
        /// <param name="title">title (required).</param>
        /// <param name="description">description (required).</param>
        /// <param name="manifestSha256">The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. (required).</param>
        /// <param name="episodesTotal">episodesTotal (required).</param>
        /// <param name="tasks">tasks (required).</param>
        /// <param name="splits">splits (required).</param>
        /// <param name="controlRateHz">Actions per simulated second. (required).</param>
        /// <param name="maxSteps">Steps after which an episode is truncated. (required).</param>
        /// <param name="maxChunk">maxChunk (required).</param>
        /// <param name="maxAttempts">maxAttempts (required).</param>
        /// <param name="maxFaults">maxFaults (required).</param>
        /// <param name="successRule">A &#x60;SuccessRule&#x60;, or one of a later version. (required).</param>
        /// <param name="actionSpace">Name of an action value → what it means. (required).</param>
        /// <param name="observationSpace">observationSpace (required).</param>
        /// <param name="imageSizes">Sizes that may be chosen at submit; the first is the default. (required).</param>
        /// <param name="imageCodecs">Codecs that may be chosen at submit; the first is the default. (required).</param>
        /// <param name="simulator">simulator (required).</param>
        /// <param name="unavailableReason">Why a run cannot be submitted here now, and the cure; null when it can. (required).</param>
        public Benchmark(string benchmarkId = default, string varVersion = default, string title = default, string description = default, string manifestSha256 = default, int episodesTotal = default, List<string> tasks = default, List<string> splits = default, double controlRateHz = default, int maxSteps = default, int maxChunk = default, int maxAttempts = default, int maxFaults = default, string successRule = default, Dictionary<string, VectorSpace> actionSpace = default, ObservationSpace observationSpace = default, List<ImageSize> imageSizes = default, List<string> imageCodecs = default, SimulatorInfo simulator = default, string unavailableReason = default)
        {
            // to ensure "benchmarkId" is required (not null)
            if (benchmarkId == null)
            {
                throw new ArgumentNullException("benchmarkId is a required property for Benchmark and cannot be null");
            }
            this.BenchmarkId = benchmarkId;
            // to ensure "varVersion" is required (not null)
            if (varVersion == null)
            {
                throw new ArgumentNullException("varVersion is a required property for Benchmark and cannot be null");
            }
            this.VarVersion = varVersion;
            // to ensure "title" is required (not null)
            if (title == null)
            {
                throw new ArgumentNullException("title is a required property for Benchmark and cannot be null");
            }
            this.Title = title;
            // to ensure "description" is required (not null)
            if (description == null)
            {
                throw new ArgumentNullException("description is a required property for Benchmark and cannot be null");
            }
            this.Description = description;
            // to ensure "manifestSha256" is required (not null)
            if (manifestSha256 == null)
            {
                throw new ArgumentNullException("manifestSha256 is a required property for Benchmark and cannot be null");
            }
            this.ManifestSha256 = manifestSha256;
            this.EpisodesTotal = episodesTotal;
            // to ensure "tasks" is required (not null)
            if (tasks == null)
            {
                throw new ArgumentNullException("tasks is a required property for Benchmark and cannot be null");
            }
            this.Tasks = tasks;
            // to ensure "splits" is required (not null)
            if (splits == null)
            {
                throw new ArgumentNullException("splits is a required property for Benchmark and cannot be null");
            }
            this.Splits = splits;
            this.ControlRateHz = controlRateHz;
            this.MaxSteps = maxSteps;
            this.MaxChunk = maxChunk;
            this.MaxAttempts = maxAttempts;
            this.MaxFaults = maxFaults;
            // to ensure "successRule" is required (not null)
            if (successRule == null)
            {
                throw new ArgumentNullException("successRule is a required property for Benchmark and cannot be null");
            }
            this.SuccessRule = successRule;
            // to ensure "actionSpace" is required (not null)
            if (actionSpace == null)
            {
                throw new ArgumentNullException("actionSpace is a required property for Benchmark and cannot be null");
            }
            this.ActionSpace = actionSpace;
            // to ensure "observationSpace" is required (not null)
            if (observationSpace == null)
            {
                throw new ArgumentNullException("observationSpace is a required property for Benchmark and cannot be null");
            }
            this.ObservationSpace = observationSpace;
            // to ensure "imageSizes" is required (not null)
            if (imageSizes == null)
            {
                throw new ArgumentNullException("imageSizes is a required property for Benchmark and cannot be null");
            }
            this.ImageSizes = imageSizes;
            // to ensure "imageCodecs" is required (not null)
            if (imageCodecs == null)
            {
                throw new ArgumentNullException("imageCodecs is a required property for Benchmark and cannot be null");
            }
            this.ImageCodecs = imageCodecs;
            // to ensure "simulator" is required (not null)
            if (simulator == null)
            {
                throw new ArgumentNullException("simulator is a required property for Benchmark and cannot be null");
            }
            this.Simulator = simulator;
            // to ensure "unavailableReason" is required (not null)
            if (unavailableReason == null)
            {
                throw new ArgumentNullException("unavailableReason is a required property for Benchmark and cannot be null");
            }
            this.UnavailableReason = unavailableReason;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets BenchmarkId
        /// </summary>
        [DataMember(Name = "benchmark_id", IsRequired = true, EmitDefaultValue = true)]
        public string BenchmarkId { get; set; }

        /// <summary>
        /// Gets or Sets VarVersion
        /// </summary>
        [DataMember(Name = "version", IsRequired = true, EmitDefaultValue = true)]
        public string VarVersion { get; set; }

        /// <summary>
        /// Gets or Sets Title
        /// </summary>
        [DataMember(Name = "title", IsRequired = true, EmitDefaultValue = true)]
        public string Title { get; set; }

        /// <summary>
        /// Gets or Sets Description
        /// </summary>
        [DataMember(Name = "description", IsRequired = true, EmitDefaultValue = true)]
        public string Description { get; set; }

        /// <summary>
        /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
        /// </summary>
        /// <value>The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.</value>
        [DataMember(Name = "manifest_sha256", IsRequired = true, EmitDefaultValue = true)]
        public string ManifestSha256 { get; set; }

        /// <summary>
        /// Gets or Sets EpisodesTotal
        /// </summary>
        [DataMember(Name = "episodes_total", IsRequired = true, EmitDefaultValue = true)]
        public int EpisodesTotal { get; set; }

        /// <summary>
        /// Gets or Sets Tasks
        /// </summary>
        [DataMember(Name = "tasks", IsRequired = true, EmitDefaultValue = true)]
        public List<string> Tasks { get; set; }

        /// <summary>
        /// Gets or Sets Splits
        /// </summary>
        [DataMember(Name = "splits", IsRequired = true, EmitDefaultValue = true)]
        public List<string> Splits { get; set; }

        /// <summary>
        /// Actions per simulated second.
        /// </summary>
        /// <value>Actions per simulated second.</value>
        [DataMember(Name = "control_rate_hz", IsRequired = true, EmitDefaultValue = true)]
        public double ControlRateHz { get; set; }

        /// <summary>
        /// Steps after which an episode is truncated.
        /// </summary>
        /// <value>Steps after which an episode is truncated.</value>
        [DataMember(Name = "max_steps", IsRequired = true, EmitDefaultValue = true)]
        public int MaxSteps { get; set; }

        /// <summary>
        /// Gets or Sets MaxChunk
        /// </summary>
        [DataMember(Name = "max_chunk", IsRequired = true, EmitDefaultValue = true)]
        public int MaxChunk { get; set; }

        /// <summary>
        /// Gets or Sets MaxAttempts
        /// </summary>
        [DataMember(Name = "max_attempts", IsRequired = true, EmitDefaultValue = true)]
        public int MaxAttempts { get; set; }

        /// <summary>
        /// Gets or Sets MaxFaults
        /// </summary>
        [DataMember(Name = "max_faults", IsRequired = true, EmitDefaultValue = true)]
        public int MaxFaults { get; set; }

        /// <summary>
        /// A &#x60;SuccessRule&#x60;, or one of a later version.
        /// </summary>
        /// <value>A &#x60;SuccessRule&#x60;, or one of a later version.</value>
        [DataMember(Name = "success_rule", IsRequired = true, EmitDefaultValue = true)]
        public string SuccessRule { get; set; }

        /// <summary>
        /// Name of an action value → what it means.
        /// </summary>
        /// <value>Name of an action value → what it means.</value>
        [DataMember(Name = "action_space", IsRequired = true, EmitDefaultValue = true)]
        public Dictionary<string, VectorSpace> ActionSpace { get; set; }

        /// <summary>
        /// Gets or Sets ObservationSpace
        /// </summary>
        [DataMember(Name = "observation_space", IsRequired = true, EmitDefaultValue = true)]
        public ObservationSpace ObservationSpace { get; set; }

        /// <summary>
        /// Sizes that may be chosen at submit; the first is the default.
        /// </summary>
        /// <value>Sizes that may be chosen at submit; the first is the default.</value>
        [DataMember(Name = "image_sizes", IsRequired = true, EmitDefaultValue = true)]
        public List<ImageSize> ImageSizes { get; set; }

        /// <summary>
        /// Codecs that may be chosen at submit; the first is the default.
        /// </summary>
        /// <value>Codecs that may be chosen at submit; the first is the default.</value>
        [DataMember(Name = "image_codecs", IsRequired = true, EmitDefaultValue = true)]
        public List<string> ImageCodecs { get; set; }

        /// <summary>
        /// Gets or Sets Simulator
        /// </summary>
        [DataMember(Name = "simulator", IsRequired = true, EmitDefaultValue = true)]
        public SimulatorInfo Simulator { get; set; }

        /// <summary>
        /// Why a run cannot be submitted here now, and the cure; null when it can.
        /// </summary>
        /// <value>Why a run cannot be submitted here now, and the cure; null when it can.</value>
        [DataMember(Name = "unavailable_reason", IsRequired = true, EmitDefaultValue = true)]
        public string UnavailableReason { get; set; }

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
            sb.Append("class Benchmark {\n");
            sb.Append("  BenchmarkId: ").Append(BenchmarkId).Append("\n");
            sb.Append("  VarVersion: ").Append(VarVersion).Append("\n");
            sb.Append("  Title: ").Append(Title).Append("\n");
            sb.Append("  Description: ").Append(Description).Append("\n");
            sb.Append("  ManifestSha256: ").Append(ManifestSha256).Append("\n");
            sb.Append("  EpisodesTotal: ").Append(EpisodesTotal).Append("\n");
            sb.Append("  Tasks: ").Append(Tasks).Append("\n");
            sb.Append("  Splits: ").Append(Splits).Append("\n");
            sb.Append("  ControlRateHz: ").Append(ControlRateHz).Append("\n");
            sb.Append("  MaxSteps: ").Append(MaxSteps).Append("\n");
            sb.Append("  MaxChunk: ").Append(MaxChunk).Append("\n");
            sb.Append("  MaxAttempts: ").Append(MaxAttempts).Append("\n");
            sb.Append("  MaxFaults: ").Append(MaxFaults).Append("\n");
            sb.Append("  SuccessRule: ").Append(SuccessRule).Append("\n");
            sb.Append("  ActionSpace: ").Append(ActionSpace).Append("\n");
            sb.Append("  ObservationSpace: ").Append(ObservationSpace).Append("\n");
            sb.Append("  ImageSizes: ").Append(ImageSizes).Append("\n");
            sb.Append("  ImageCodecs: ").Append(ImageCodecs).Append("\n");
            sb.Append("  Simulator: ").Append(Simulator).Append("\n");
            sb.Append("  UnavailableReason: ").Append(UnavailableReason).Append("\n");
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

            // EpisodesTotal (int) minimum
            if (this.EpisodesTotal < (int)1)
            {
                yield return new ValidationResult("Invalid value for EpisodesTotal, must be a value greater than or equal to 1.", new [] { "EpisodesTotal" });
            }

            // MaxSteps (int) minimum
            if (this.MaxSteps < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxSteps, must be a value greater than or equal to 1.", new [] { "MaxSteps" });
            }

            // MaxChunk (int) minimum
            if (this.MaxChunk < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxChunk, must be a value greater than or equal to 1.", new [] { "MaxChunk" });
            }

            // MaxAttempts (int) minimum
            if (this.MaxAttempts < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxAttempts, must be a value greater than or equal to 1.", new [] { "MaxAttempts" });
            }

            // MaxFaults (int) minimum
            if (this.MaxFaults < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxFaults, must be a value greater than or equal to 1.", new [] { "MaxFaults" });
            }

            if (this.SuccessRule != null) {
                // SuccessRule (string) pattern
                Regex regexSuccessRule = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexSuccessRule.Match(this.SuccessRule).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for SuccessRule, must match a pattern of " + regexSuccessRule, new [] { "SuccessRule" });
                }
            }

            yield break;
        }
    }

}
