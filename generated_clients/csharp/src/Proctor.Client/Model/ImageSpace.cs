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
    /// ImageSpace
    /// </summary>
    [DataContract(Name = "ImageSpace")]
    public partial class ImageSpace : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ImageSpace" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ImageSpace()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ImageSpace" /> class.
        /// </summary>
        /// <param name="channels">channels (required).</param>
        /// <param name="description">description (required).</param>
        /// <param name="tasks">tasks.</param>
        public ImageSpace(int channels = default, string description = default, List<string> tasks = default)
        {
            this.Channels = channels;
            // to ensure "description" is required (not null)
            if (description == null)
            {
                throw new ArgumentNullException("description is a required property for ImageSpace and cannot be null");
            }
            this.Description = description;
            this.Tasks = tasks;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Channels
        /// </summary>
        [DataMember(Name = "channels", IsRequired = true, EmitDefaultValue = true)]
        public int Channels { get; set; }

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
            sb.Append("class ImageSpace {\n");
            sb.Append("  Channels: ").Append(Channels).Append("\n");
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
            // Channels (int) maximum
            if (this.Channels > (int)4)
            {
                yield return new ValidationResult("Invalid value for Channels, must be a value less than or equal to 4.", new [] { "Channels" });
            }

            // Channels (int) minimum
            if (this.Channels < (int)1)
            {
                yield return new ValidationResult("Invalid value for Channels, must be a value greater than or equal to 1.", new [] { "Channels" });
            }

            yield break;
        }
    }

}
