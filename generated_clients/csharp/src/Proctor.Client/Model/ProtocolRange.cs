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
    /// ProtocolRange
    /// </summary>
    [DataContract(Name = "ProtocolRange")]
    public partial class ProtocolRange : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ProtocolRange" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ProtocolRange()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ProtocolRange" /> class.
        /// </summary>
        /// <param name="min">min (required).</param>
        /// <param name="max">max (required).</param>
        public ProtocolRange(string min = default, string max = default)
        {
            // to ensure "min" is required (not null)
            if (min == null)
            {
                throw new ArgumentNullException("min is a required property for ProtocolRange and cannot be null");
            }
            this.Min = min;
            // to ensure "max" is required (not null)
            if (max == null)
            {
                throw new ArgumentNullException("max is a required property for ProtocolRange and cannot be null");
            }
            this.Max = max;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Min
        /// </summary>
        [DataMember(Name = "min", IsRequired = true, EmitDefaultValue = true)]
        public string Min { get; set; }

        /// <summary>
        /// Gets or Sets Max
        /// </summary>
        [DataMember(Name = "max", IsRequired = true, EmitDefaultValue = true)]
        public string Max { get; set; }

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
            sb.Append("class ProtocolRange {\n");
            sb.Append("  Min: ").Append(Min).Append("\n");
            sb.Append("  Max: ").Append(Max).Append("\n");
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
            if (this.Min != null) {
                // Min (string) pattern
                Regex regexMin = new Regex(@"^[0-9]+\.[0-9]+$", RegexOptions.CultureInvariant);
                if (!regexMin.Match(this.Min).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Min, must match a pattern of " + regexMin, new [] { "Min" });
                }
            }

            if (this.Max != null) {
                // Max (string) pattern
                Regex regexMax = new Regex(@"^[0-9]+\.[0-9]+$", RegexOptions.CultureInvariant);
                if (!regexMax.Match(this.Max).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Max, must match a pattern of " + regexMax, new [] { "Max" });
                }
            }

            yield break;
        }
    }

}
