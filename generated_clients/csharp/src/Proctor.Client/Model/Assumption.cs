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
    /// Assumption
    /// </summary>
    [DataContract(Name = "Assumption")]
    public partial class Assumption : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Assumption" /> class.
        /// </summary>
        /// <param name="size">size.</param>
        /// <param name="unit">unit.</param>
        /// <param name="rotation">rotation.</param>
        /// <param name="frame">frame.</param>
        /// <param name="relative">relative.</param>
        /// <param name="gripperOpen">gripperOpen.</param>
        public Assumption(int size = default, string unit = default, string rotation = default, string frame = default, bool relative = default, double gripperOpen = default)
        {
            this.Size = size;
            this.Unit = unit;
            this.Rotation = rotation;
            this.Frame = frame;
            this.Relative = relative;
            this.GripperOpen = gripperOpen;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Size
        /// </summary>
        [DataMember(Name = "size", EmitDefaultValue = false)]
        public int Size { get; set; }

        /// <summary>
        /// Gets or Sets Unit
        /// </summary>
        [DataMember(Name = "unit", EmitDefaultValue = false)]
        public string Unit { get; set; }

        /// <summary>
        /// Gets or Sets Rotation
        /// </summary>
        [DataMember(Name = "rotation", EmitDefaultValue = false)]
        public string Rotation { get; set; }

        /// <summary>
        /// Gets or Sets Frame
        /// </summary>
        [DataMember(Name = "frame", EmitDefaultValue = false)]
        public string Frame { get; set; }

        /// <summary>
        /// Gets or Sets Relative
        /// </summary>
        [DataMember(Name = "relative", EmitDefaultValue = true)]
        public bool Relative { get; set; }

        /// <summary>
        /// Gets or Sets GripperOpen
        /// </summary>
        [DataMember(Name = "gripper_open", EmitDefaultValue = false)]
        public double GripperOpen { get; set; }

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
            sb.Append("class Assumption {\n");
            sb.Append("  Size: ").Append(Size).Append("\n");
            sb.Append("  Unit: ").Append(Unit).Append("\n");
            sb.Append("  Rotation: ").Append(Rotation).Append("\n");
            sb.Append("  Frame: ").Append(Frame).Append("\n");
            sb.Append("  Relative: ").Append(Relative).Append("\n");
            sb.Append("  GripperOpen: ").Append(GripperOpen).Append("\n");
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

            // Unit (string) maxLength
            if (this.Unit != null && this.Unit.Length > 64)
            {
                yield return new ValidationResult("Invalid value for Unit, length must be less than 64.", new [] { "Unit" });
            }

            if (this.Rotation != null) {
                // Rotation (string) pattern
                Regex regexRotation = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexRotation.Match(this.Rotation).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Rotation, must match a pattern of " + regexRotation, new [] { "Rotation" });
                }
            }

            // Frame (string) maxLength
            if (this.Frame != null && this.Frame.Length > 64)
            {
                yield return new ValidationResult("Invalid value for Frame, length must be less than 64.", new [] { "Frame" });
            }

            yield break;
        }
    }

}
