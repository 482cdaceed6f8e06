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
    /// Progress
    /// </summary>
    [DataContract(Name = "Progress")]
    public partial class Progress : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Progress" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Progress()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Progress" /> class.
        /// </summary>
        /// <param name="episodesTotal">episodesTotal (required).</param>
        /// <param name="episodesScored">Abandoned ones included. (required).</param>
        /// <param name="episodesInProgress">episodesInProgress (required).</param>
        /// <param name="episodesPending">episodesPending (required).</param>
        public Progress(int episodesTotal = default, int episodesScored = default, int episodesInProgress = default, int episodesPending = default)
        {
            this.EpisodesTotal = episodesTotal;
            this.EpisodesScored = episodesScored;
            this.EpisodesInProgress = episodesInProgress;
            this.EpisodesPending = episodesPending;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets EpisodesTotal
        /// </summary>
        [DataMember(Name = "episodes_total", IsRequired = true, EmitDefaultValue = true)]
        public int EpisodesTotal { get; set; }

        /// <summary>
        /// Abandoned ones included.
        /// </summary>
        /// <value>Abandoned ones included.</value>
        [DataMember(Name = "episodes_scored", IsRequired = true, EmitDefaultValue = true)]
        public int EpisodesScored { get; set; }

        /// <summary>
        /// Gets or Sets EpisodesInProgress
        /// </summary>
        [DataMember(Name = "episodes_in_progress", IsRequired = true, EmitDefaultValue = true)]
        public int EpisodesInProgress { get; set; }

        /// <summary>
        /// Gets or Sets EpisodesPending
        /// </summary>
        [DataMember(Name = "episodes_pending", IsRequired = true, EmitDefaultValue = true)]
        public int EpisodesPending { get; set; }

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
            sb.Append("class Progress {\n");
            sb.Append("  EpisodesTotal: ").Append(EpisodesTotal).Append("\n");
            sb.Append("  EpisodesScored: ").Append(EpisodesScored).Append("\n");
            sb.Append("  EpisodesInProgress: ").Append(EpisodesInProgress).Append("\n");
            sb.Append("  EpisodesPending: ").Append(EpisodesPending).Append("\n");
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
            yield break;
        }
    }

}
