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
    /// Recorded with the result, because it changes the score.
    /// </summary>
    [DataContract(Name = "ImageChoice")]
    public partial class ImageChoice : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ImageChoice" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ImageChoice()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ImageChoice" /> class.
        /// </summary>
        /// <param name="codec">codec (required).</param>
        /// <param name="width">width (required).</param>
        /// <param name="height">height (required).</param>
        public ImageChoice(string codec = default, int width = default, int height = default)
        {
            // to ensure "codec" is required (not null)
            if (codec == null)
            {
                throw new ArgumentNullException("codec is a required property for ImageChoice and cannot be null");
            }
            this.Codec = codec;
            this.Width = width;
            this.Height = height;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Codec
        /// </summary>
        [DataMember(Name = "codec", IsRequired = true, EmitDefaultValue = true)]
        public string Codec { get; set; }

        /// <summary>
        /// Gets or Sets Width
        /// </summary>
        [DataMember(Name = "width", IsRequired = true, EmitDefaultValue = true)]
        public int Width { get; set; }

        /// <summary>
        /// Gets or Sets Height
        /// </summary>
        [DataMember(Name = "height", IsRequired = true, EmitDefaultValue = true)]
        public int Height { get; set; }

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
            sb.Append("class ImageChoice {\n");
            sb.Append("  Codec: ").Append(Codec).Append("\n");
            sb.Append("  Width: ").Append(Width).Append("\n");
            sb.Append("  Height: ").Append(Height).Append("\n");
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
            if (this.Codec != null) {
                // Codec (string) pattern
                Regex regexCodec = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexCodec.Match(this.Codec).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Codec, must match a pattern of " + regexCodec, new [] { "Codec" });
                }
            }

            // Width (int) maximum
            if (this.Width > (int)4096)
            {
                yield return new ValidationResult("Invalid value for Width, must be a value less than or equal to 4096.", new [] { "Width" });
            }

            // Width (int) minimum
            if (this.Width < (int)1)
            {
                yield return new ValidationResult("Invalid value for Width, must be a value greater than or equal to 1.", new [] { "Width" });
            }

            // Height (int) maximum
            if (this.Height > (int)4096)
            {
                yield return new ValidationResult("Invalid value for Height, must be a value less than or equal to 4096.", new [] { "Height" });
            }

            // Height (int) minimum
            if (this.Height < (int)1)
            {
                yield return new ValidationResult("Invalid value for Height, must be a value greater than or equal to 1.", new [] { "Height" });
            }

            yield break;
        }
    }

}
