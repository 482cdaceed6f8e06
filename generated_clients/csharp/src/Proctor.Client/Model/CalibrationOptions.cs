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
    /// Only for the benchmark &#x60;calibration&#x60;, which the submitter shapes.
    /// </summary>
    [DataContract(Name = "CalibrationOptions")]
    public partial class CalibrationOptions : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets SuccessRule
        /// </summary>
        [DataMember(Name = "success_rule", EmitDefaultValue = false)]
        public SuccessRule? SuccessRule { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="CalibrationOptions" /> class.
        /// </summary>
        /// <param name="tasks">One entry per episode, in order; one &#x60;score&#x60; episode when absent..</param>
        /// <param name="maxSteps">10 when absent..</param>
        /// <param name="successRule">successRule.</param>
        /// <param name="maxAttempts">3 when absent..</param>
        /// <param name="maxFaults">3 when absent..</param>
        /// <param name="queueS">Seconds for which the run stays queued after submit and after resume; 0 when absent..</param>
        public CalibrationOptions(List<CalibrationTask> tasks = default, int maxSteps = default, SuccessRule? successRule = default, int maxAttempts = default, int maxFaults = default, double queueS = default)
        {
            this.Tasks = tasks;
            this.MaxSteps = maxSteps;
            this.SuccessRule = successRule;
            this.MaxAttempts = maxAttempts;
            this.MaxFaults = maxFaults;
            this.QueueS = queueS;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// One entry per episode, in order; one &#x60;score&#x60; episode when absent.
        /// </summary>
        /// <value>One entry per episode, in order; one &#x60;score&#x60; episode when absent.</value>
        [DataMember(Name = "tasks", EmitDefaultValue = false)]
        public List<CalibrationTask> Tasks { get; set; }

        /// <summary>
        /// 10 when absent.
        /// </summary>
        /// <value>10 when absent.</value>
        [DataMember(Name = "max_steps", EmitDefaultValue = false)]
        public int MaxSteps { get; set; }

        /// <summary>
        /// 3 when absent.
        /// </summary>
        /// <value>3 when absent.</value>
        [DataMember(Name = "max_attempts", EmitDefaultValue = false)]
        public int MaxAttempts { get; set; }

        /// <summary>
        /// 3 when absent.
        /// </summary>
        /// <value>3 when absent.</value>
        [DataMember(Name = "max_faults", EmitDefaultValue = false)]
        public int MaxFaults { get; set; }

        /// <summary>
        /// Seconds for which the run stays queued after submit and after resume; 0 when absent.
        /// </summary>
        /// <value>Seconds for which the run stays queued after submit and after resume; 0 when absent.</value>
        [DataMember(Name = "queue_s", EmitDefaultValue = false)]
        public double QueueS { get; set; }

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
            sb.Append("class CalibrationOptions {\n");
            sb.Append("  Tasks: ").Append(Tasks).Append("\n");
            sb.Append("  MaxSteps: ").Append(MaxSteps).Append("\n");
            sb.Append("  SuccessRule: ").Append(SuccessRule).Append("\n");
            sb.Append("  MaxAttempts: ").Append(MaxAttempts).Append("\n");
            sb.Append("  MaxFaults: ").Append(MaxFaults).Append("\n");
            sb.Append("  QueueS: ").Append(QueueS).Append("\n");
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
            // MaxSteps (int) maximum
            if (this.MaxSteps > (int)10000)
            {
                yield return new ValidationResult("Invalid value for MaxSteps, must be a value less than or equal to 10000.", new [] { "MaxSteps" });
            }

            // MaxSteps (int) minimum
            if (this.MaxSteps < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxSteps, must be a value greater than or equal to 1.", new [] { "MaxSteps" });
            }

            // MaxAttempts (int) maximum
            if (this.MaxAttempts > (int)10)
            {
                yield return new ValidationResult("Invalid value for MaxAttempts, must be a value less than or equal to 10.", new [] { "MaxAttempts" });
            }

            // MaxAttempts (int) minimum
            if (this.MaxAttempts < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxAttempts, must be a value greater than or equal to 1.", new [] { "MaxAttempts" });
            }

            // MaxFaults (int) maximum
            if (this.MaxFaults > (int)10)
            {
                yield return new ValidationResult("Invalid value for MaxFaults, must be a value less than or equal to 10.", new [] { "MaxFaults" });
            }

            // MaxFaults (int) minimum
            if (this.MaxFaults < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxFaults, must be a value greater than or equal to 1.", new [] { "MaxFaults" });
            }

            // QueueS (double) maximum
            if (this.QueueS > (double)10)
            {
                yield return new ValidationResult("Invalid value for QueueS, must be a value less than or equal to 10.", new [] { "QueueS" });
            }

            // QueueS (double) minimum
            if (this.QueueS < (double)0)
            {
                yield return new ValidationResult("Invalid value for QueueS, must be a value greater than or equal to 0.", new [] { "QueueS" });
            }

            yield break;
        }
    }

}
