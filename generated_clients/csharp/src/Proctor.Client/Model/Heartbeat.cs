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
    /// Heartbeat
    /// </summary>
    [DataContract(Name = "Heartbeat")]
    public partial class Heartbeat : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Heartbeat" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Heartbeat()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Heartbeat" /> class.
        /// </summary>
        /// <param name="sessionId">sessionId (required).</param>
        public Heartbeat(string sessionId = default)
        {
            // to ensure "sessionId" is required (not null)
            if (sessionId == null)
            {
                throw new ArgumentNullException("sessionId is a required property for Heartbeat and cannot be null");
            }
            this.SessionId = sessionId;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets SessionId
        /// </summary>
        [DataMember(Name = "session_id", IsRequired = true, EmitDefaultValue = true)]
        public string SessionId { get; set; }

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
            sb.Append("class Heartbeat {\n");
            sb.Append("  SessionId: ").Append(SessionId).Append("\n");
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
            // SessionId (string) maxLength
            if (this.SessionId != null && this.SessionId.Length > 128)
            {
                yield return new ValidationResult("Invalid value for SessionId, length must be less than 128.", new [] { "SessionId" });
            }

            // SessionId (string) minLength
            if (this.SessionId != null && this.SessionId.Length < 1)
            {
                yield return new ValidationResult("Invalid value for SessionId, length must be greater than 1.", new [] { "SessionId" });
            }

            yield break;
        }
    }

}
