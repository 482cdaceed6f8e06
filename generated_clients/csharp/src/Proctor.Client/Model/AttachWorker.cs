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
    /// AttachWorker
    /// </summary>
    [DataContract(Name = "AttachWorker")]
    public partial class AttachWorker : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="AttachWorker" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected AttachWorker()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="AttachWorker" /> class.
        /// </summary>
        /// <param name="attachKey">Chosen anew for every attachment; repeated only to repeat a lost request. (required).</param>
        /// <param name="takeover">Fence out a live session; false when absent..</param>
        /// <param name="assumes">assumes.</param>
        public AttachWorker(string attachKey = default, bool takeover = default, Assumptions assumes = default)
        {
            // to ensure "attachKey" is required (not null)
            if (attachKey == null)
            {
                throw new ArgumentNullException("attachKey is a required property for AttachWorker and cannot be null");
            }
            this.AttachKey = attachKey;
            this.Takeover = takeover;
            this.Assumes = assumes;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Chosen anew for every attachment; repeated only to repeat a lost request.
        /// </summary>
        /// <value>Chosen anew for every attachment; repeated only to repeat a lost request.</value>
        [DataMember(Name = "attach_key", IsRequired = true, EmitDefaultValue = true)]
        public string AttachKey { get; set; }

        /// <summary>
        /// Fence out a live session; false when absent.
        /// </summary>
        /// <value>Fence out a live session; false when absent.</value>
        [DataMember(Name = "takeover", EmitDefaultValue = true)]
        public bool Takeover { get; set; }

        /// <summary>
        /// Gets or Sets Assumes
        /// </summary>
        [DataMember(Name = "assumes", EmitDefaultValue = false)]
        public Assumptions Assumes { get; set; }

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
            sb.Append("class AttachWorker {\n");
            sb.Append("  AttachKey: ").Append(AttachKey).Append("\n");
            sb.Append("  Takeover: ").Append(Takeover).Append("\n");
            sb.Append("  Assumes: ").Append(Assumes).Append("\n");
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
            // AttachKey (string) maxLength
            if (this.AttachKey != null && this.AttachKey.Length > 128)
            {
                yield return new ValidationResult("Invalid value for AttachKey, length must be less than 128.", new [] { "AttachKey" });
            }

            // AttachKey (string) minLength
            if (this.AttachKey != null && this.AttachKey.Length < 1)
            {
                yield return new ValidationResult("Invalid value for AttachKey, length must be greater than 1.", new [] { "AttachKey" });
            }

            yield break;
        }
    }

}
