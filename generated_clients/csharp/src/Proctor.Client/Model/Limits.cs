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
    /// Limits
    /// </summary>
    [DataContract(Name = "Limits")]
    public partial class Limits : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Limits" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Limits()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Limits" /> class.
        /// </summary>
        /// <param name="maxBodyBytes">Longest request body that is read. (required).</param>
        /// <param name="maxWorkers">Most live workers a run may ask for. (required).</param>
        /// <param name="maxChunk">Most actions in one predict; a benchmark may allow fewer. (required).</param>
        /// <param name="idleTimeoutSMin">idleTimeoutSMin (required).</param>
        /// <param name="idleTimeoutSMax">idleTimeoutSMax (required).</param>
        /// <param name="waitSMax">Longest wait that a long-poll is granted. (required).</param>
        public Limits(long maxBodyBytes = default, int maxWorkers = default, int maxChunk = default, double idleTimeoutSMin = default, double idleTimeoutSMax = default, int waitSMax = default)
        {
            this.MaxBodyBytes = maxBodyBytes;
            this.MaxWorkers = maxWorkers;
            this.MaxChunk = maxChunk;
            this.IdleTimeoutSMin = idleTimeoutSMin;
            this.IdleTimeoutSMax = idleTimeoutSMax;
            this.WaitSMax = waitSMax;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Longest request body that is read.
        /// </summary>
        /// <value>Longest request body that is read.</value>
        [DataMember(Name = "max_body_bytes", IsRequired = true, EmitDefaultValue = true)]
        public long MaxBodyBytes { get; set; }

        /// <summary>
        /// Most live workers a run may ask for.
        /// </summary>
        /// <value>Most live workers a run may ask for.</value>
        [DataMember(Name = "max_workers", IsRequired = true, EmitDefaultValue = true)]
        public int MaxWorkers { get; set; }

        /// <summary>
        /// Most actions in one predict; a benchmark may allow fewer.
        /// </summary>
        /// <value>Most actions in one predict; a benchmark may allow fewer.</value>
        [DataMember(Name = "max_chunk", IsRequired = true, EmitDefaultValue = true)]
        public int MaxChunk { get; set; }

        /// <summary>
        /// Gets or Sets IdleTimeoutSMin
        /// </summary>
        [DataMember(Name = "idle_timeout_s_min", IsRequired = true, EmitDefaultValue = true)]
        public double IdleTimeoutSMin { get; set; }

        /// <summary>
        /// Gets or Sets IdleTimeoutSMax
        /// </summary>
        [DataMember(Name = "idle_timeout_s_max", IsRequired = true, EmitDefaultValue = true)]
        public double IdleTimeoutSMax { get; set; }

        /// <summary>
        /// Longest wait that a long-poll is granted.
        /// </summary>
        /// <value>Longest wait that a long-poll is granted.</value>
        [DataMember(Name = "wait_s_max", IsRequired = true, EmitDefaultValue = true)]
        public int WaitSMax { get; set; }

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
            sb.Append("class Limits {\n");
            sb.Append("  MaxBodyBytes: ").Append(MaxBodyBytes).Append("\n");
            sb.Append("  MaxWorkers: ").Append(MaxWorkers).Append("\n");
            sb.Append("  MaxChunk: ").Append(MaxChunk).Append("\n");
            sb.Append("  IdleTimeoutSMin: ").Append(IdleTimeoutSMin).Append("\n");
            sb.Append("  IdleTimeoutSMax: ").Append(IdleTimeoutSMax).Append("\n");
            sb.Append("  WaitSMax: ").Append(WaitSMax).Append("\n");
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
            // MaxBodyBytes (long) minimum
            if (this.MaxBodyBytes < (long)65536)
            {
                yield return new ValidationResult("Invalid value for MaxBodyBytes, must be a value greater than or equal to 65536.", new [] { "MaxBodyBytes" });
            }

            // MaxWorkers (int) minimum
            if (this.MaxWorkers < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxWorkers, must be a value greater than or equal to 1.", new [] { "MaxWorkers" });
            }

            // MaxChunk (int) minimum
            if (this.MaxChunk < (int)4)
            {
                yield return new ValidationResult("Invalid value for MaxChunk, must be a value greater than or equal to 4.", new [] { "MaxChunk" });
            }

            yield break;
        }
    }

}
