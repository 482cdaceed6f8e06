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
    [DataContract(Name = "Comparison")]
    public partial class Comparison : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Comparison" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Comparison()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Comparison" /> class.
        /// </summary>
        /// <param name="baseline">Id of the run that the others are compared with. (required).</param>
        /// <param name="benchmarkId">benchmarkId (required).</param>
        /// <param name="manifestSha256">The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. (required).</param>
        /// <param name="tolerance">tolerance (required).</param>
        /// <param name="runs">One entry per run that was named, in that order. (required).</param>
        public Comparison(string baseline = default, string benchmarkId = default, string manifestSha256 = default, double tolerance = default, List<ComparedRun> runs = default)
        {
            // to ensure "baseline" is required (not null)
            if (baseline == null)
            {
                throw new ArgumentNullException("baseline is a required property for Comparison and cannot be null");
            }
            this.Baseline = baseline;
            // to ensure "benchmarkId" is required (not null)
            if (benchmarkId == null)
            {
                throw new ArgumentNullException("benchmarkId is a required property for Comparison and cannot be null");
            }
            this.BenchmarkId = benchmarkId;
            // to ensure "manifestSha256" is required (not null)
            if (manifestSha256 == null)
            {
                throw new ArgumentNullException("manifestSha256 is a required property for Comparison and cannot be null");
            }
            this.ManifestSha256 = manifestSha256;
            this.Tolerance = tolerance;
            // to ensure "runs" is required (not null)
            if (runs == null)
            {
                throw new ArgumentNullException("runs is a required property for Comparison and cannot be null");
            }
            this.Runs = runs;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Id of the run that the others are compared with.
        /// </summary>
        /// <value>Id of the run that the others are compared with.</value>
        [DataMember(Name = "baseline", IsRequired = true, EmitDefaultValue = true)]
        public string Baseline { get; set; }

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
        /// Gets or Sets Tolerance
        /// </summary>
        [DataMember(Name = "tolerance", IsRequired = true, EmitDefaultValue = true)]
        public double Tolerance { get; set; }

        /// <summary>
        /// One entry per run that was named, in that order.
        /// </summary>
        /// <value>One entry per run that was named, in that order.</value>
        [DataMember(Name = "runs", IsRequired = true, EmitDefaultValue = true)]
        public List<ComparedRun> Runs { get; set; }

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
            sb.Append("class Comparison {\n");
            sb.Append("  Baseline: ").Append(Baseline).Append("\n");
            sb.Append("  BenchmarkId: ").Append(BenchmarkId).Append("\n");
            sb.Append("  ManifestSha256: ").Append(ManifestSha256).Append("\n");
            sb.Append("  Tolerance: ").Append(Tolerance).Append("\n");
            sb.Append("  Runs: ").Append(Runs).Append("\n");
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

            // Tolerance (double) maximum
            if (this.Tolerance > (double)1)
            {
                yield return new ValidationResult("Invalid value for Tolerance, must be a value less than or equal to 1.", new [] { "Tolerance" });
            }

            // Tolerance (double) minimum
            if (this.Tolerance < (double)0)
            {
                yield return new ValidationResult("Invalid value for Tolerance, must be a value greater than or equal to 0.", new [] { "Tolerance" });
            }

            yield break;
        }
    }

}
