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
    /// TensorSpace
    /// </summary>
    [DataContract(Name = "TensorSpace")]
    public partial class TensorSpace : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="TensorSpace" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected TensorSpace()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="TensorSpace" /> class.
        /// </summary>
        /// <param name="dtype">dtype (required).</param>
        /// <param name="shape">shape (required).</param>
        /// <param name="description">description (required).</param>
        /// <param name="tasks">tasks.</param>
        public TensorSpace(string dtype = default, List<int> shape = default, string description = default, List<string> tasks = default)
        {
            // to ensure "dtype" is required (not null)
            if (dtype == null)
            {
                throw new ArgumentNullException("dtype is a required property for TensorSpace and cannot be null");
            }
            this.Dtype = dtype;
            // to ensure "shape" is required (not null)
            if (shape == null)
            {
                throw new ArgumentNullException("shape is a required property for TensorSpace and cannot be null");
            }
            this.Shape = shape;
            // to ensure "description" is required (not null)
            if (description == null)
            {
                throw new ArgumentNullException("description is a required property for TensorSpace and cannot be null");
            }
            this.Description = description;
            this.Tasks = tasks;
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
        public List<int> Shape { get; set; }

        /// <summary>
        /// Gets or Sets Description
        /// </summary>
        [DataMember(Name = "description", IsRequired = true, EmitDefaultValue = true)]
        public string Description { get; set; }

        /// <summary>
        /// Gets or Sets Tasks
        /// </summary>
        [DataMember(Name = "tasks", EmitDefaultValue = false)]
        public List<string> Tasks { get; set; }

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
            sb.Append("class TensorSpace {\n");
            sb.Append("  Dtype: ").Append(Dtype).Append("\n");
            sb.Append("  Shape: ").Append(Shape).Append("\n");
            sb.Append("  Description: ").Append(Description).Append("\n");
            sb.Append("  Tasks: ").Append(Tasks).Append("\n");
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
