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
    /// ComparedTask
    /// </summary>
    [DataContract(Name = "ComparedTask")]
    public partial class ComparedTask : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ComparedTask" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ComparedTask()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ComparedTask" /> class.
        /// </summary>
        /// <param name="paired">paired (required).</param>
        /// <param name="baselineMean">baselineMean (required).</param>
        /// <param name="mean">mean (required).</param>
        /// <param name="difference">difference (required).</param>
        public ComparedTask(int paired = default, double? baselineMean = default, double? mean = default, double? difference = default)
        {
            this.Paired = paired;
            // to ensure "baselineMean" is required (not null)
            if (baselineMean == null)
            {
                throw new ArgumentNullException("baselineMean is a required property for ComparedTask and cannot be null");
            }
            this.BaselineMean = baselineMean;
            // to ensure "mean" is required (not null)
            if (mean == null)
            {
                throw new ArgumentNullException("mean is a required property for ComparedTask and cannot be null");
            }
            this.Mean = mean;
            // to ensure "difference" is required (not null)
            if (difference == null)
            {
                throw new ArgumentNullException("difference is a required property for ComparedTask and cannot be null");
            }
            this.Difference = difference;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Paired
        /// </summary>
        [DataMember(Name = "paired", IsRequired = true, EmitDefaultValue = true)]
        public int Paired { get; set; }

        /// <summary>
        /// Gets or Sets BaselineMean
        /// </summary>
        [DataMember(Name = "baseline_mean", IsRequired = true, EmitDefaultValue = true)]
        public double? BaselineMean { get; set; }

        /// <summary>
        /// Gets or Sets Mean
        /// </summary>
        [DataMember(Name = "mean", IsRequired = true, EmitDefaultValue = true)]
        public double? Mean { get; set; }

        /// <summary>
        /// Gets or Sets Difference
        /// </summary>
        [DataMember(Name = "difference", IsRequired = true, EmitDefaultValue = true)]
        public double? Difference { get; set; }

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
            sb.Append("class ComparedTask {\n");
            sb.Append("  Paired: ").Append(Paired).Append("\n");
            sb.Append("  BaselineMean: ").Append(BaselineMean).Append("\n");
            sb.Append("  Mean: ").Append(Mean).Append("\n");
            sb.Append("  Difference: ").Append(Difference).Append("\n");
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

            yield break;
        }
    }

}
