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
    /// ObservationSpace
    /// </summary>
    [DataContract(Name = "ObservationSpace")]
    public partial class ObservationSpace : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ObservationSpace" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ObservationSpace()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ObservationSpace" /> class.
        /// </summary>
        /// <param name="state">state (required).</param>
        /// <param name="images">images (required).</param>
        /// <param name="tensors">tensors (required).</param>
        public ObservationSpace(Dictionary<string, VectorSpace> state = default, Dictionary<string, ImageSpace> images = default, Dictionary<string, TensorSpace> tensors = default)
        {
            // to ensure "state" is required (not null)
            if (state == null)
            {
                throw new ArgumentNullException("state is a required property for ObservationSpace and cannot be null");
            }
            this.State = state;
            // to ensure "images" is required (not null)
            if (images == null)
            {
                throw new ArgumentNullException("images is a required property for ObservationSpace and cannot be null");
            }
            this.Images = images;
            // to ensure "tensors" is required (not null)
            if (tensors == null)
            {
                throw new ArgumentNullException("tensors is a required property for ObservationSpace and cannot be null");
            }
            this.Tensors = tensors;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets State
        /// </summary>
        [DataMember(Name = "state", IsRequired = true, EmitDefaultValue = true)]
        public Dictionary<string, VectorSpace> State { get; set; }

        /// <summary>
        /// Gets or Sets Images
        /// </summary>
        [DataMember(Name = "images", IsRequired = true, EmitDefaultValue = true)]
        public Dictionary<string, ImageSpace> Images { get; set; }

        /// <summary>
        /// Gets or Sets Tensors
        /// </summary>
        [DataMember(Name = "tensors", IsRequired = true, EmitDefaultValue = true)]
        public Dictionary<string, TensorSpace> Tensors { get; set; }

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
            sb.Append("class ObservationSpace {\n");
            sb.Append("  State: ").Append(State).Append("\n");
            sb.Append("  Images: ").Append(Images).Append("\n");
            sb.Append("  Tensors: ").Append(Tensors).Append("\n");
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
