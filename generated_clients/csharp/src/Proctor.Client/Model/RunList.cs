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
    /// RunList
    /// </summary>
    [DataContract(Name = "RunList")]
    public partial class RunList : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="RunList" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected RunList()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="RunList" /> class.
        /// </summary>
        /// <param name="runs">runs (required).</param>
        /// <param name="nextCursor">nextCursor (required).</param>
        public RunList(List<Run> runs = default, string nextCursor = default)
        {
            // to ensure "runs" is required (not null)
            if (runs == null)
            {
                throw new ArgumentNullException("runs is a required property for RunList and cannot be null");
            }
            this.Runs = runs;
            // to ensure "nextCursor" is required (not null)
            if (nextCursor == null)
            {
                throw new ArgumentNullException("nextCursor is a required property for RunList and cannot be null");
            }
            this.NextCursor = nextCursor;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Runs
        /// </summary>
        [DataMember(Name = "runs", IsRequired = true, EmitDefaultValue = true)]
        public List<Run> Runs { get; set; }

        /// <summary>
        /// Gets or Sets NextCursor
        /// </summary>
        [DataMember(Name = "next_cursor", IsRequired = true, EmitDefaultValue = true)]
        public string NextCursor { get; set; }

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
            sb.Append("class RunList {\n");
            sb.Append("  Runs: ").Append(Runs).Append("\n");
            sb.Append("  NextCursor: ").Append(NextCursor).Append("\n");
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
