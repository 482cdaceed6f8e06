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
    /// Server time of this turn, in seconds.
    /// </summary>
    [DataContract(Name = "Timing")]
    public partial class Timing : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Timing" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Timing()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Timing" /> class.
        /// </summary>
        /// <param name="totalS">totalS (required).</param>
        /// <param name="queueS">queueS (required).</param>
        /// <param name="simulateS">simulateS (required).</param>
        /// <param name="renderS">renderS (required).</param>
        /// <param name="encodeS">Encoding of images. (required).</param>
        public Timing(double totalS = default, double queueS = default, double simulateS = default, double renderS = default, double encodeS = default)
        {
            this.TotalS = totalS;
            this.QueueS = queueS;
            this.SimulateS = simulateS;
            this.RenderS = renderS;
            this.EncodeS = encodeS;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets TotalS
        /// </summary>
        [DataMember(Name = "total_s", IsRequired = true, EmitDefaultValue = true)]
        public double TotalS { get; set; }

        /// <summary>
        /// Gets or Sets QueueS
        /// </summary>
        [DataMember(Name = "queue_s", IsRequired = true, EmitDefaultValue = true)]
        public double QueueS { get; set; }

        /// <summary>
        /// Gets or Sets SimulateS
        /// </summary>
        [DataMember(Name = "simulate_s", IsRequired = true, EmitDefaultValue = true)]
        public double SimulateS { get; set; }

        /// <summary>
        /// Gets or Sets RenderS
        /// </summary>
        [DataMember(Name = "render_s", IsRequired = true, EmitDefaultValue = true)]
        public double RenderS { get; set; }

        /// <summary>
        /// Encoding of images.
        /// </summary>
        /// <value>Encoding of images.</value>
        [DataMember(Name = "encode_s", IsRequired = true, EmitDefaultValue = true)]
        public double EncodeS { get; set; }

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
            sb.Append("class Timing {\n");
            sb.Append("  TotalS: ").Append(TotalS).Append("\n");
            sb.Append("  QueueS: ").Append(QueueS).Append("\n");
            sb.Append("  SimulateS: ").Append(SimulateS).Append("\n");
            sb.Append("  RenderS: ").Append(RenderS).Append("\n");
            sb.Append("  EncodeS: ").Append(EncodeS).Append("\n");
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
            // TotalS (double) minimum
            if (this.TotalS < (double)0)
            {
                yield return new ValidationResult("Invalid value for TotalS, must be a value greater than or equal to 0.", new [] { "TotalS" });
            }

            // QueueS (double) minimum
            if (this.QueueS < (double)0)
            {
                yield return new ValidationResult("Invalid value for QueueS, must be a value greater than or equal to 0.", new [] { "QueueS" });
            }

            // SimulateS (double) minimum
            if (this.SimulateS < (double)0)
            {
                yield return new ValidationResult("Invalid value for SimulateS, must be a value greater than or equal to 0.", new [] { "SimulateS" });
            }

            // RenderS (double) minimum
            if (this.RenderS < (double)0)
            {
                yield return new ValidationResult("Invalid value for RenderS, must be a value greater than or equal to 0.", new [] { "RenderS" });
            }

            // EncodeS (double) minimum
            if (this.EncodeS < (double)0)
            {
                yield return new ValidationResult("Invalid value for EncodeS, must be a value greater than or equal to 0.", new [] { "EncodeS" });
            }

            yield break;
        }
    }

}
