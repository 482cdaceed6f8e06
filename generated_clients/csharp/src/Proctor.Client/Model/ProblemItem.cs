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
    /// ProblemItem
    /// </summary>
    [DataContract(Name = "ProblemItem")]
    public partial class ProblemItem : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="ProblemItem" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected ProblemItem()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="ProblemItem" /> class.
        /// </summary>
        /// <param name="pointer">JSON pointer into the body, to the faulty member or a part of it; or &#x60;query:name&#x60;, &#x60;header:name&#x60;, &#x60;path:name&#x60;. (required).</param>
        /// <param name="detail">detail (required).</param>
        public ProblemItem(string pointer = default, string detail = default)
        {
            // to ensure "pointer" is required (not null)
            if (pointer == null)
            {
                throw new ArgumentNullException("pointer is a required property for ProblemItem and cannot be null");
            }
            this.Pointer = pointer;
            // to ensure "detail" is required (not null)
            if (detail == null)
            {
                throw new ArgumentNullException("detail is a required property for ProblemItem and cannot be null");
            }
            this.Detail = detail;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// JSON pointer into the body, to the faulty member or a part of it; or &#x60;query:name&#x60;, &#x60;header:name&#x60;, &#x60;path:name&#x60;.
        /// </summary>
        /// <value>JSON pointer into the body, to the faulty member or a part of it; or &#x60;query:name&#x60;, &#x60;header:name&#x60;, &#x60;path:name&#x60;.</value>
        [DataMember(Name = "pointer", IsRequired = true, EmitDefaultValue = true)]
        public string Pointer { get; set; }

        /// <summary>
        /// Gets or Sets Detail
        /// </summary>
        [DataMember(Name = "detail", IsRequired = true, EmitDefaultValue = true)]
        public string Detail { get; set; }

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
            sb.Append("class ProblemItem {\n");
            sb.Append("  Pointer: ").Append(Pointer).Append("\n");
            sb.Append("  Detail: ").Append(Detail).Append("\n");
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
