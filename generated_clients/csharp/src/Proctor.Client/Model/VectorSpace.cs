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
    /// One named vector of numbers, with every convention a policy could get wrong.
    /// </summary>
    [DataContract(Name = "VectorSpace")]
    public partial class VectorSpace : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="VectorSpace" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected VectorSpace()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="VectorSpace" /> class.
        /// </summary>
        /// <param name="size">size (required).</param>
        /// <param name="unit">&#x60;rad&#x60;, &#x60;m&#x60;, &#x60;1&#x60;, or several joined by commas. (required).</param>
        /// <param name="rotation">rotation (required).</param>
        /// <param name="frame">&#x60;world&#x60;, &#x60;base&#x60;, &#x60;tool&#x60;, &#x60;joint&#x60;, or &#x60;none&#x60;. (required).</param>
        /// <param name="relative">True when the values are increments. (required).</param>
        /// <param name="gripperOpen">The value that means fully open..</param>
        /// <param name="minimum">minimum.</param>
        /// <param name="maximum">maximum.</param>
        /// <param name="outOfRange">outOfRange (required).</param>
        /// <param name="description">What the numbers are..</param>
        /// <param name="tasks">The tasks that have this entry; all of them when absent..</param>
        public VectorSpace(int size = default, string unit = default, string rotation = default, string frame = default, bool relative = default, double gripperOpen = default, List<double> minimum = default, List<double> maximum = default, string outOfRange = default, string description = default, List<string> tasks = default)
        {
            this.Size = size;
            // to ensure "unit" is required (not null)
            if (unit == null)
            {
                throw new ArgumentNullException("unit is a required property for VectorSpace and cannot be null");
            }
            this.Unit = unit;
            // to ensure "rotation" is required (not null)
            if (rotation == null)
            {
                throw new ArgumentNullException("rotation is a required property for VectorSpace and cannot be null");
            }
            this.Rotation = rotation;
            // to ensure "frame" is required (not null)
            if (frame == null)
            {
                throw new ArgumentNullException("frame is a required property for VectorSpace and cannot be null");
            }
            this.Frame = frame;
            this.Relative = relative;
            // to ensure "outOfRange" is required (not null)
            if (outOfRange == null)
            {
                throw new ArgumentNullException("outOfRange is a required property for VectorSpace and cannot be null");
            }
            this.OutOfRange = outOfRange;
            this.GripperOpen = gripperOpen;
            this.Minimum = minimum;
            this.Maximum = maximum;
            this.Description = description;
            this.Tasks = tasks;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Size
        /// </summary>
        [DataMember(Name = "size", IsRequired = true, EmitDefaultValue = true)]
        public int Size { get; set; }

        /// <summary>
        /// &#x60;rad&#x60;, &#x60;m&#x60;, &#x60;1&#x60;, or several joined by commas.
        /// </summary>
        /// <value>&#x60;rad&#x60;, &#x60;m&#x60;, &#x60;1&#x60;, or several joined by commas.</value>
        [DataMember(Name = "unit", IsRequired = true, EmitDefaultValue = true)]
        public string Unit { get; set; }

        /// <summary>
        /// Gets or Sets Rotation
        /// </summary>
        [DataMember(Name = "rotation", IsRequired = true, EmitDefaultValue = true)]
        public string Rotation { get; set; }

        /// <summary>
        /// &#x60;world&#x60;, &#x60;base&#x60;, &#x60;tool&#x60;, &#x60;joint&#x60;, or &#x60;none&#x60;.
        /// </summary>
        /// <value>&#x60;world&#x60;, &#x60;base&#x60;, &#x60;tool&#x60;, &#x60;joint&#x60;, or &#x60;none&#x60;.</value>
        [DataMember(Name = "frame", IsRequired = true, EmitDefaultValue = true)]
        public string Frame { get; set; }

        /// <summary>
        /// True when the values are increments.
        /// </summary>
        /// <value>True when the values are increments.</value>
        [DataMember(Name = "relative", IsRequired = true, EmitDefaultValue = true)]
        public bool Relative { get; set; }

        /// <summary>
        /// The value that means fully open.
        /// </summary>
        /// <value>The value that means fully open.</value>
        [DataMember(Name = "gripper_open", EmitDefaultValue = false)]
        public double GripperOpen { get; set; }

        /// <summary>
        /// Gets or Sets Minimum
        /// </summary>
        [DataMember(Name = "minimum", EmitDefaultValue = false)]
        public List<double> Minimum { get; set; }

        /// <summary>
        /// Gets or Sets Maximum
        /// </summary>
        [DataMember(Name = "maximum", EmitDefaultValue = false)]
        public List<double> Maximum { get; set; }

        /// <summary>
        /// Gets or Sets OutOfRange
        /// </summary>
        [DataMember(Name = "out_of_range", IsRequired = true, EmitDefaultValue = true)]
        public string OutOfRange { get; set; }

        /// <summary>
        /// What the numbers are.
        /// </summary>
        /// <value>What the numbers are.</value>
        [DataMember(Name = "description", EmitDefaultValue = false)]
        public string Description { get; set; }

        /// <summary>
        /// The tasks that have this entry; all of them when absent.
        /// </summary>
        /// <value>The tasks that have this entry; all of them when absent.</value>
        [DataMember(Name = "tasks", EmitDefaultValue = false)]
        public List<string> Tasks { get; set; }

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
            sb.Append("class VectorSpace {\n");
            sb.Append("  Size: ").Append(Size).Append("\n");
            sb.Append("  Unit: ").Append(Unit).Append("\n");
            sb.Append("  Rotation: ").Append(Rotation).Append("\n");
            sb.Append("  Frame: ").Append(Frame).Append("\n");
            sb.Append("  Relative: ").Append(Relative).Append("\n");
            sb.Append("  GripperOpen: ").Append(GripperOpen).Append("\n");
            sb.Append("  Minimum: ").Append(Minimum).Append("\n");
            sb.Append("  Maximum: ").Append(Maximum).Append("\n");
            sb.Append("  OutOfRange: ").Append(OutOfRange).Append("\n");
            sb.Append("  Description: ").Append(Description).Append("\n");
            sb.Append("  Tasks: ").Append(Tasks).Append("\n");
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
            // Size (int) minimum
            if (this.Size < (int)1)
            {
                yield return new ValidationResult("Invalid value for Size, must be a value greater than or equal to 1.", new [] { "Size" });
            }

            if (this.Rotation != null) {
                // Rotation (string) pattern
                Regex regexRotation = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexRotation.Match(this.Rotation).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Rotation, must match a pattern of " + regexRotation, new [] { "Rotation" });
                }
            }

            if (this.OutOfRange != null) {
                // OutOfRange (string) pattern
                Regex regexOutOfRange = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexOutOfRange.Match(this.OutOfRange).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for OutOfRange, must match a pattern of " + regexOutOfRange, new [] { "OutOfRange" });
                }
            }

            yield break;
        }
    }

}
