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
    /// Predict
    /// </summary>
    [DataContract(Name = "Predict")]
    public partial class Predict : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets Observe
        /// </summary>
        [DataMember(Name = "observe", EmitDefaultValue = false)]
        public Observe? Observe { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="Predict" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Predict()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Predict" /> class.
        /// </summary>
        /// <param name="sessionId">sessionId (required).</param>
        /// <param name="seq">seq (required).</param>
        /// <param name="actions">actions (required).</param>
        /// <param name="observe">observe.</param>
        public Predict(string sessionId = default, long seq = default, List<Action> actions = default, Observe? observe = default)
        {
            // to ensure "sessionId" is required (not null)
            if (sessionId == null)
            {
                throw new ArgumentNullException("sessionId is a required property for Predict and cannot be null");
            }
            this.SessionId = sessionId;
            this.Seq = seq;
            // to ensure "actions" is required (not null)
            if (actions == null)
            {
                throw new ArgumentNullException("actions is a required property for Predict and cannot be null");
            }
            this.Actions = actions;
            this.Observe = observe;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets SessionId
        /// </summary>
        [DataMember(Name = "session_id", IsRequired = true, EmitDefaultValue = true)]
        public string SessionId { get; set; }

        /// <summary>
        /// Gets or Sets Seq
        /// </summary>
        [DataMember(Name = "seq", IsRequired = true, EmitDefaultValue = true)]
        public long Seq { get; set; }

        /// <summary>
        /// Gets or Sets Actions
        /// </summary>
        [DataMember(Name = "actions", IsRequired = true, EmitDefaultValue = true)]
        public List<Action> Actions { get; set; }

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
            sb.Append("class Predict {\n");
            sb.Append("  SessionId: ").Append(SessionId).Append("\n");
            sb.Append("  Seq: ").Append(Seq).Append("\n");
            sb.Append("  Actions: ").Append(Actions).Append("\n");
            sb.Append("  Observe: ").Append(Observe).Append("\n");
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

            // Seq (long) maximum
            if (this.Seq > (long)9007199254740991)
            {
                yield return new ValidationResult("Invalid value for Seq, must be a value less than or equal to 9007199254740991.", new [] { "Seq" });
            }

            // Seq (long) minimum
            if (this.Seq < (long)1)
            {
                yield return new ValidationResult("Invalid value for Seq, must be a value greater than or equal to 1.", new [] { "Seq" });
            }

            yield break;
        }
    }

}
