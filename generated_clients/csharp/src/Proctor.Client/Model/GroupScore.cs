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
    /// GroupScore
    /// </summary>
    [DataContract(Name = "GroupScore")]
    public partial class GroupScore : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="GroupScore" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected GroupScore()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="GroupScore" /> class.
        /// </summary>
        /// <param name="counts">counts (required).</param>
        /// <param name="mean">mean (required).</param>
        /// <param name="successRate">successRate (required).</param>
        public GroupScore(OutcomeCounts counts = default, double? mean = default, double? successRate = default)
        {
            // to ensure "counts" is required (not null)
            if (counts == null)
            {
                throw new ArgumentNullException("counts is a required property for GroupScore and cannot be null");
            }
            this.Counts = counts;
            // to ensure "mean" is required (not null)
            if (mean == null)
            {
                throw new ArgumentNullException("mean is a required property for GroupScore and cannot be null");
            }
            this.Mean = mean;
            // to ensure "successRate" is required (not null)
            if (successRate == null)
            {
                throw new ArgumentNullException("successRate is a required property for GroupScore and cannot be null");
            }
            this.SuccessRate = successRate;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Counts
        /// </summary>
        [DataMember(Name = "counts", IsRequired = true, EmitDefaultValue = true)]
        public OutcomeCounts Counts { get; set; }

        /// <summary>
        /// Gets or Sets Mean
        /// </summary>
        [DataMember(Name = "mean", IsRequired = true, EmitDefaultValue = true)]
        public double? Mean { get; set; }

        /// <summary>
        /// Gets or Sets SuccessRate
        /// </summary>
        [DataMember(Name = "success_rate", IsRequired = true, EmitDefaultValue = true)]
        public double? SuccessRate { get; set; }

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
            sb.Append("class GroupScore {\n");
            sb.Append("  Counts: ").Append(Counts).Append("\n");
            sb.Append("  Mean: ").Append(Mean).Append("\n");
            sb.Append("  SuccessRate: ").Append(SuccessRate).Append("\n");
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
