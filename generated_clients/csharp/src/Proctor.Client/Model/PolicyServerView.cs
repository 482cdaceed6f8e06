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
    /// The policy server of a run with mode &#x60;push&#x60;, with what was left open filled in, and without its key.
    /// </summary>
    [DataContract(Name = "PolicyServerView")]
    public partial class PolicyServerView : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyServerView" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected PolicyServerView()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyServerView" /> class.
        /// </summary>
        /// <param name="url">url (required).</param>
        /// <param name="protocol">A &#x60;PolicyProtocol&#x60;, or one of a later version. (required).</param>
        /// <param name="hasApiKey">hasApiKey (required).</param>
        /// <param name="model">model.</param>
        /// <param name="callTimeoutS">callTimeoutS (required).</param>
        /// <param name="maxConcurrent">maxConcurrent (required).</param>
        /// <param name="maxRetries">maxRetries (required).</param>
        /// <param name="generation">generation.</param>
        public PolicyServerView(string url = default, string protocol = default, bool hasApiKey = default, string model = default, double callTimeoutS = default, int maxConcurrent = default, int maxRetries = default, Dictionary<string, double> generation = default)
        {
            // to ensure "url" is required (not null)
            if (url == null)
            {
                throw new ArgumentNullException("url is a required property for PolicyServerView and cannot be null");
            }
            this.Url = url;
            // to ensure "protocol" is required (not null)
            if (protocol == null)
            {
                throw new ArgumentNullException("protocol is a required property for PolicyServerView and cannot be null");
            }
            this.Protocol = protocol;
            this.HasApiKey = hasApiKey;
            this.CallTimeoutS = callTimeoutS;
            this.MaxConcurrent = maxConcurrent;
            this.MaxRetries = maxRetries;
            this.Model = model;
            this.Generation = generation;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Url
        /// </summary>
        [DataMember(Name = "url", IsRequired = true, EmitDefaultValue = true)]
        public string Url { get; set; }

        /// <summary>
        /// A &#x60;PolicyProtocol&#x60;, or one of a later version.
        /// </summary>
        /// <value>A &#x60;PolicyProtocol&#x60;, or one of a later version.</value>
        [DataMember(Name = "protocol", IsRequired = true, EmitDefaultValue = true)]
        public string Protocol { get; set; }

        /// <summary>
        /// Gets or Sets HasApiKey
        /// </summary>
        [DataMember(Name = "has_api_key", IsRequired = true, EmitDefaultValue = true)]
        public bool HasApiKey { get; set; }

        /// <summary>
        /// Gets or Sets Model
        /// </summary>
        [DataMember(Name = "model", EmitDefaultValue = false)]
        public string Model { get; set; }

        /// <summary>
        /// Gets or Sets CallTimeoutS
        /// </summary>
        [DataMember(Name = "call_timeout_s", IsRequired = true, EmitDefaultValue = true)]
        public double CallTimeoutS { get; set; }

        /// <summary>
        /// Gets or Sets MaxConcurrent
        /// </summary>
        [DataMember(Name = "max_concurrent", IsRequired = true, EmitDefaultValue = true)]
        public int MaxConcurrent { get; set; }

        /// <summary>
        /// Gets or Sets MaxRetries
        /// </summary>
        [DataMember(Name = "max_retries", IsRequired = true, EmitDefaultValue = true)]
        public int MaxRetries { get; set; }

        /// <summary>
        /// Gets or Sets Generation
        /// </summary>
        [DataMember(Name = "generation", EmitDefaultValue = false)]
        public Dictionary<string, double> Generation { get; set; }

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
            sb.Append("class PolicyServerView {\n");
            sb.Append("  Url: ").Append(Url).Append("\n");
            sb.Append("  Protocol: ").Append(Protocol).Append("\n");
            sb.Append("  HasApiKey: ").Append(HasApiKey).Append("\n");
            sb.Append("  Model: ").Append(Model).Append("\n");
            sb.Append("  CallTimeoutS: ").Append(CallTimeoutS).Append("\n");
            sb.Append("  MaxConcurrent: ").Append(MaxConcurrent).Append("\n");
            sb.Append("  MaxRetries: ").Append(MaxRetries).Append("\n");
            sb.Append("  Generation: ").Append(Generation).Append("\n");
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
            if (this.Protocol != null) {
                // Protocol (string) pattern
                Regex regexProtocol = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexProtocol.Match(this.Protocol).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Protocol, must match a pattern of " + regexProtocol, new [] { "Protocol" });
                }
            }

            yield break;
        }
    }

}
