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
    /// What the policy takes for granted; refused when the benchmark says otherwise.
    /// </summary>
    [DataContract(Name = "Assumptions")]
    public partial class Assumptions : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Assumptions" /> class.
        /// </summary>
        /// <param name="controlRateHz">controlRateHz.</param>
        /// <param name="action">action.</param>
        /// <param name="state">state.</param>
        public Assumptions(double controlRateHz = default, Dictionary<string, Assumption> action = default, Dictionary<string, Assumption> state = default)
        {
            this.ControlRateHz = controlRateHz;
            this.Action = action;
            this.State = state;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets ControlRateHz
        /// </summary>
        [DataMember(Name = "control_rate_hz", EmitDefaultValue = false)]
        public double ControlRateHz { get; set; }

        /// <summary>
        /// Gets or Sets Action
        /// </summary>
        [DataMember(Name = "action", EmitDefaultValue = false)]
        public Dictionary<string, Assumption> Action { get; set; }

        /// <summary>
        /// Gets or Sets State
        /// </summary>
        [DataMember(Name = "state", EmitDefaultValue = false)]
        public Dictionary<string, Assumption> State { get; set; }

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
            sb.Append("class Assumptions {\n");
            sb.Append("  ControlRateHz: ").Append(ControlRateHz).Append("\n");
            sb.Append("  Action: ").Append(Action).Append("\n");
            sb.Append("  State: ").Append(State).Append("\n");
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
            // ControlRateHz (double) minimum
            if (this.ControlRateHz < (double)0)
            {
                yield return new ValidationResult("Invalid value for ControlRateHz, must be a value greater than or equal to 0.", new [] { "ControlRateHz" });
            }

            yield break;
        }
    }

}
