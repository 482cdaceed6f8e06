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
    /// C order, little-endian; a bool is one byte, 0 or 1.
    /// </summary>
    [DataContract(Name = "Tensor")]
    public partial class Tensor : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Tensor" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Tensor()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Tensor" /> class.
        /// </summary>
        /// <param name="dtype">dtype (required).</param>
        /// <param name="shape">shape (required).</param>
        /// <param name="data">Base64 with padding in JSON; &#x60;bin&#x60; in MessagePack. (required).</param>
        public Tensor(string dtype = default, List<long> shape = default, string data = default)
        {
            // to ensure "dtype" is required (not null)
            if (dtype == null)
            {
                throw new ArgumentNullException("dtype is a required property for Tensor and cannot be null");
            }
            this.Dtype = dtype;
            // to ensure "shape" is required (not null)
            if (shape == null)
            {
                throw new ArgumentNullException("shape is a required property for Tensor and cannot be null");
            }
            this.Shape = shape;
            // to ensure "data" is required (not null)
            if (data == null)
            {
                throw new ArgumentNullException("data is a required property for Tensor and cannot be null");
            }
            this.Data = data;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Dtype
        /// </summary>
        [DataMember(Name = "dtype", IsRequired = true, EmitDefaultValue = true)]
        public string Dtype { get; set; }

        /// <summary>
        /// Gets or Sets Shape
        /// </summary>
        [DataMember(Name = "shape", IsRequired = true, EmitDefaultValue = true)]
        public List<long> Shape { get; set; }

        /// <summary>
        /// Base64 with padding in JSON; &#x60;bin&#x60; in MessagePack.
        /// </summary>
        /// <value>Base64 with padding in JSON; &#x60;bin&#x60; in MessagePack.</value>
        [DataMember(Name = "data", IsRequired = true, EmitDefaultValue = true)]
        public string Data { get; set; }

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
            sb.Append("class Tensor {\n");
            sb.Append("  Dtype: ").Append(Dtype).Append("\n");
            sb.Append("  Shape: ").Append(Shape).Append("\n");
            sb.Append("  Data: ").Append(Data).Append("\n");
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
            if (this.Dtype != null) {
                // Dtype (string) pattern
                Regex regexDtype = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexDtype.Match(this.Dtype).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Dtype, must match a pattern of " + regexDtype, new [] { "Dtype" });
                }
            }

            yield break;
        }
    }

}
