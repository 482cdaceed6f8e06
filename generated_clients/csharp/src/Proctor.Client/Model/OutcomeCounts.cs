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
    /// OutcomeCounts
    /// </summary>
    [DataContract(Name = "OutcomeCounts")]
    public partial class OutcomeCounts : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="OutcomeCounts" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected OutcomeCounts()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="OutcomeCounts" /> class.
        /// </summary>
        /// <param name="total">total (required).</param>
        /// <param name="success">success (required).</param>
        /// <param name="failure">failure (required).</param>
        /// <param name="abandoned">abandoned (required).</param>
        /// <param name="unscored">unscored (required).</param>
        public OutcomeCounts(int total = default, int success = default, int failure = default, int abandoned = default, int unscored = default)
        {
            this.Total = total;
            this.Success = success;
            this.Failure = failure;
            this.Abandoned = abandoned;
            this.Unscored = unscored;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Total
        /// </summary>
        [DataMember(Name = "total", IsRequired = true, EmitDefaultValue = true)]
        public int Total { get; set; }

        /// <summary>
        /// Gets or Sets Success
        /// </summary>
        [DataMember(Name = "success", IsRequired = true, EmitDefaultValue = true)]
        public int Success { get; set; }

        /// <summary>
        /// Gets or Sets Failure
        /// </summary>
        [DataMember(Name = "failure", IsRequired = true, EmitDefaultValue = true)]
        public int Failure { get; set; }

        /// <summary>
        /// Gets or Sets Abandoned
        /// </summary>
        [DataMember(Name = "abandoned", IsRequired = true, EmitDefaultValue = true)]
        public int Abandoned { get; set; }

        /// <summary>
        /// Gets or Sets Unscored
        /// </summary>
        [DataMember(Name = "unscored", IsRequired = true, EmitDefaultValue = true)]
        public int Unscored { get; set; }

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
            sb.Append("class OutcomeCounts {\n");
            sb.Append("  Total: ").Append(Total).Append("\n");
            sb.Append("  Success: ").Append(Success).Append("\n");
            sb.Append("  Failure: ").Append(Failure).Append("\n");
            sb.Append("  Abandoned: ").Append(Abandoned).Append("\n");
            sb.Append("  Unscored: ").Append(Unscored).Append("\n");
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
