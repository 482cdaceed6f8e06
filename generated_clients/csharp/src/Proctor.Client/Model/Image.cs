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
    /// RGB or grey, row 0 on top; raw is height × width × channels bytes.
    /// </summary>
    [DataContract(Name = "Image")]
    public partial class Image : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Image" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Image()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Image" /> class.
        /// </summary>
        /// <param name="codec">codec (required).</param>
        /// <param name="width">width (required).</param>
        /// <param name="height">height (required).</param>
        /// <param name="channels">channels (required).</param>
        /// <param name="data">Base64 with padding in JSON; &#x60;bin&#x60; in MessagePack. (required).</param>
        public Image(string codec = default, int width = default, int height = default, int channels = default, string data = default)
        {
            // to ensure "codec" is required (not null)
            if (codec == null)
            {
                throw new ArgumentNullException("codec is a required property for Image and cannot be null");
            }
            this.Codec = codec;
            this.Width = width;
            this.Height = height;
            this.Channels = channels;
            // to ensure "data" is required (not null)
            if (data == null)
            {
                throw new ArgumentNullException("data is a required property for Image and cannot be null");
            }
            this.Data = data;
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
        /// Gets or Sets Channels
        /// </summary>
        [DataMember(Name = "channels", IsRequired = true, EmitDefaultValue = true)]
        public int Channels { get; set; }

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
            sb.Append("class Image {\n");
            sb.Append("  Codec: ").Append(Codec).Append("\n");
            sb.Append("  Width: ").Append(Width).Append("\n");
            sb.Append("  Height: ").Append(Height).Append("\n");
            sb.Append("  Channels: ").Append(Channels).Append("\n");
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
            if (this.Codec != null) {
                // Codec (string) pattern
                Regex regexCodec = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexCodec.Match(this.Codec).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Codec, must match a pattern of " + regexCodec, new [] { "Codec" });
                }
            }

            // Width (int) minimum
            if (this.Width < (int)1)
            {
                yield return new ValidationResult("Invalid value for Width, must be a value greater than or equal to 1.", new [] { "Width" });
            }

            // Height (int) minimum
            if (this.Height < (int)1)
            {
                yield return new ValidationResult("Invalid value for Height, must be a value greater than or equal to 1.", new [] { "Height" });
            }

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
