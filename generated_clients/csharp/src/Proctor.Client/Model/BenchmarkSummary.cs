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
    /// BenchmarkSummary
    /// </summary>
    [DataContract(Name = "BenchmarkSummary")]
    public partial class BenchmarkSummary : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="BenchmarkSummary" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected BenchmarkSummary()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="BenchmarkSummary" /> class.
        /// </summary>
        /// <param name="benchmarkId">benchmarkId (required).</param>
        /// <param name="varVersion">varVersion (required).</param>
        /// <param name="title">title (required).</param>
        /// <param name="manifestSha256">The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. (required).</param>
        /// <param name="episodesTotal">episodesTotal (required).</param>
        public BenchmarkSummary(string benchmarkId = default, string varVersion = default, string title = default, string manifestSha256 = default, int episodesTotal = default)
        {
            // to ensure "benchmarkId" is required (not null)
            if (benchmarkId == null)
            {
                throw new ArgumentNullException("benchmarkId is a required property for BenchmarkSummary and cannot be null");
            }
            this.BenchmarkId = benchmarkId;
            // to ensure "varVersion" is required (not null)
            if (varVersion == null)
            {
                throw new ArgumentNullException("varVersion is a required property for BenchmarkSummary and cannot be null");
            }
            this.VarVersion = varVersion;
            // to ensure "title" is required (not null)
            if (title == null)
            {
                throw new ArgumentNullException("title is a required property for BenchmarkSummary and cannot be null");
            }
            this.Title = title;
            // to ensure "manifestSha256" is required (not null)
            if (manifestSha256 == null)
            {
                throw new ArgumentNullException("manifestSha256 is a required property for BenchmarkSummary and cannot be null");
            }
            this.ManifestSha256 = manifestSha256;
            this.EpisodesTotal = episodesTotal;
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
            sb.Append("class BenchmarkSummary {\n");
            sb.Append("  BenchmarkId: ").Append(BenchmarkId).Append("\n");
            sb.Append("  VarVersion: ").Append(VarVersion).Append("\n");
            sb.Append("  Title: ").Append(Title).Append("\n");
            sb.Append("  ManifestSha256: ").Append(ManifestSha256).Append("\n");
            sb.Append("  EpisodesTotal: ").Append(EpisodesTotal).Append("\n");
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

            yield break;
        }
    }

}
