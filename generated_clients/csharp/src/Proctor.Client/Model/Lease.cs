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
    /// Lease
    /// </summary>
    [DataContract(Name = "Lease")]
    public partial class Lease : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Lease" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Lease()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Lease" /> class.
        /// </summary>
        /// <param name="expiresAt">expiresAt (required).</param>
        /// <param name="idleTimeoutS">idleTimeoutS (required).</param>
        public Lease(DateTime expiresAt = default, double idleTimeoutS = default)
        {
            this.ExpiresAt = expiresAt;
            this.IdleTimeoutS = idleTimeoutS;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets ExpiresAt
        /// </summary>
        [DataMember(Name = "expires_at", IsRequired = true, EmitDefaultValue = true)]
        public DateTime ExpiresAt { get; set; }

        /// <summary>
        /// Gets or Sets IdleTimeoutS
        /// </summary>
        [DataMember(Name = "idle_timeout_s", IsRequired = true, EmitDefaultValue = true)]
        public double IdleTimeoutS { get; set; }

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
            sb.Append("class Lease {\n");
            sb.Append("  ExpiresAt: ").Append(ExpiresAt).Append("\n");
            sb.Append("  IdleTimeoutS: ").Append(IdleTimeoutS).Append("\n");
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
