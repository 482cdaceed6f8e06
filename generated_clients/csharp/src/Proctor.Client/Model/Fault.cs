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
    /// The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed.
    /// </summary>
    [DataContract(Name = "Fault")]
    public partial class Fault : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Fault" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Fault()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Fault" /> class.
        /// </summary>
        /// <param name="episodeId">episodeId (required).</param>
        /// <param name="faults">Faults of this episode so far. (required).</param>
        /// <param name="detail">detail (required).</param>
        public Fault(string episodeId = default, int faults = default, string detail = default)
        {
            // to ensure "episodeId" is required (not null)
            if (episodeId == null)
            {
                throw new ArgumentNullException("episodeId is a required property for Fault and cannot be null");
            }
            this.EpisodeId = episodeId;
            this.Faults = faults;
            // to ensure "detail" is required (not null)
            if (detail == null)
            {
                throw new ArgumentNullException("detail is a required property for Fault and cannot be null");
            }
            this.Detail = detail;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets EpisodeId
        /// </summary>
        [DataMember(Name = "episode_id", IsRequired = true, EmitDefaultValue = true)]
        public string EpisodeId { get; set; }

        /// <summary>
        /// Faults of this episode so far.
        /// </summary>
        /// <value>Faults of this episode so far.</value>
        [DataMember(Name = "faults", IsRequired = true, EmitDefaultValue = true)]
        public int Faults { get; set; }

        /// <summary>
        /// Gets or Sets Detail
        /// </summary>
        [DataMember(Name = "detail", IsRequired = true, EmitDefaultValue = true)]
        public string Detail { get; set; }

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
            sb.Append("class Fault {\n");
            sb.Append("  EpisodeId: ").Append(EpisodeId).Append("\n");
            sb.Append("  Faults: ").Append(Faults).Append("\n");
            sb.Append("  Detail: ").Append(Detail).Append("\n");
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
            // Faults (int) minimum
            if (this.Faults < (int)1)
            {
                yield return new ValidationResult("Invalid value for Faults, must be a value greater than or equal to 1.", new [] { "Faults" });
            }

            yield break;
        }
    }

}
