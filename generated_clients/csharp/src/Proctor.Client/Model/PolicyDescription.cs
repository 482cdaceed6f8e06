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
    /// What a policy server says of itself; see policy.yaml.
    /// </summary>
    [DataContract(Name = "PolicyDescription")]
    public partial class PolicyDescription : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyDescription" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected PolicyDescription()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyDescription" /> class.
        /// </summary>
        /// <param name="name">name (required).</param>
        /// <param name="varVersion">varVersion.</param>
        /// <param name="protocol">protocol (required).</param>
        /// <param name="maxSessions">Most episodes that it plays at a time. (required).</param>
        /// <param name="assumes">assumes.</param>
        public PolicyDescription(string name = default, string varVersion = default, ProtocolRange protocol = default, int maxSessions = default, Assumptions assumes = default)
        {
            // to ensure "name" is required (not null)
            if (name == null)
            {
                throw new ArgumentNullException("name is a required property for PolicyDescription and cannot be null");
            }
            this.Name = name;
            // to ensure "protocol" is required (not null)
            if (protocol == null)
            {
                throw new ArgumentNullException("protocol is a required property for PolicyDescription and cannot be null");
            }
            this.Protocol = protocol;
            this.MaxSessions = maxSessions;
            this.VarVersion = varVersion;
            this.Assumes = assumes;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Name
        /// </summary>
        [DataMember(Name = "name", IsRequired = true, EmitDefaultValue = true)]
        public string Name { get; set; }

        /// <summary>
        /// Gets or Sets VarVersion
        /// </summary>
        [DataMember(Name = "version", EmitDefaultValue = false)]
        public string VarVersion { get; set; }

        /// <summary>
        /// Gets or Sets Protocol
        /// </summary>
        [DataMember(Name = "protocol", IsRequired = true, EmitDefaultValue = true)]
        public ProtocolRange Protocol { get; set; }

        /// <summary>
        /// Most episodes that it plays at a time.
        /// </summary>
        /// <value>Most episodes that it plays at a time.</value>
        [DataMember(Name = "max_sessions", IsRequired = true, EmitDefaultValue = true)]
        public int MaxSessions { get; set; }

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
            sb.Append("class PolicyDescription {\n");
            sb.Append("  Name: ").Append(Name).Append("\n");
            sb.Append("  VarVersion: ").Append(VarVersion).Append("\n");
            sb.Append("  Protocol: ").Append(Protocol).Append("\n");
            sb.Append("  MaxSessions: ").Append(MaxSessions).Append("\n");
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
            // Name (string) maxLength
            if (this.Name != null && this.Name.Length > 200)
            {
                yield return new ValidationResult("Invalid value for Name, length must be less than 200.", new [] { "Name" });
            }

            // Name (string) minLength
            if (this.Name != null && this.Name.Length < 1)
            {
                yield return new ValidationResult("Invalid value for Name, length must be greater than 1.", new [] { "Name" });
            }

            // VarVersion (string) maxLength
            if (this.VarVersion != null && this.VarVersion.Length > 200)
            {
                yield return new ValidationResult("Invalid value for VarVersion, length must be less than 200.", new [] { "VarVersion" });
            }

            // MaxSessions (int) maximum
            if (this.MaxSessions > (int)1024)
            {
                yield return new ValidationResult("Invalid value for MaxSessions, must be a value less than or equal to 1024.", new [] { "MaxSessions" });
            }

            // MaxSessions (int) minimum
            if (this.MaxSessions < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxSessions, must be a value greater than or equal to 1.", new [] { "MaxSessions" });
            }

            yield break;
        }
    }

}
