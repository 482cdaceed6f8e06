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
    /// Where the server finds the policy of a run with mode &#x60;push&#x60;, and how it calls it.
    /// </summary>
    [DataContract(Name = "PolicyServer")]
    public partial class PolicyServer : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets Protocol
        /// </summary>
        [DataMember(Name = "protocol", IsRequired = true, EmitDefaultValue = true)]
        public PolicyProtocol Protocol { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyServer" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected PolicyServer()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="PolicyServer" /> class.
        /// </summary>
        /// <param name="url">Base URL, without user, query or fragment; the path of an operation is appended to it. (required).</param>
        /// <param name="protocol">protocol (required).</param>
        /// <param name="apiKey">Sent as bearer token with every call, and shown to nobody..</param>
        /// <param name="model">Which model is asked, where a protocol knows several..</param>
        /// <param name="callTimeoutS">Time for one call, from connecting to the last byte of its answer; 30 when absent..</param>
        /// <param name="maxConcurrent">Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent..</param>
        /// <param name="maxRetries">How often a call that was not answered is repeated; 3 when absent..</param>
        /// <param name="generation">Numbers that a chat completion is asked with, such as &#x60;temperature&#x60; and &#x60;max_tokens&#x60;; for &#x60;openai_chat&#x60; alone..</param>
        public PolicyServer(string url = default, PolicyProtocol protocol = default, string apiKey = default, string model = default, double callTimeoutS = default, int maxConcurrent = default, int maxRetries = default, Dictionary<string, double> generation = default)
        {
            // to ensure "url" is required (not null)
            if (url == null)
            {
                throw new ArgumentNullException("url is a required property for PolicyServer and cannot be null");
            }
            this.Url = url;
            this.Protocol = protocol;
            this.ApiKey = apiKey;
            this.Model = model;
            this.CallTimeoutS = callTimeoutS;
            this.MaxConcurrent = maxConcurrent;
            this.MaxRetries = maxRetries;
            this.Generation = generation;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Base URL, without user, query or fragment; the path of an operation is appended to it.
        /// </summary>
        /// <value>Base URL, without user, query or fragment; the path of an operation is appended to it.</value>
        [DataMember(Name = "url", IsRequired = true, EmitDefaultValue = true)]
        public string Url { get; set; }

        /// <summary>
        /// Sent as bearer token with every call, and shown to nobody.
        /// </summary>
        /// <value>Sent as bearer token with every call, and shown to nobody.</value>
        [DataMember(Name = "api_key", EmitDefaultValue = false)]
        public string ApiKey { get; set; }

        /// <summary>
        /// Which model is asked, where a protocol knows several.
        /// </summary>
        /// <value>Which model is asked, where a protocol knows several.</value>
        [DataMember(Name = "model", EmitDefaultValue = false)]
        public string Model { get; set; }

        /// <summary>
        /// Time for one call, from connecting to the last byte of its answer; 30 when absent.
        /// </summary>
        /// <value>Time for one call, from connecting to the last byte of its answer; 30 when absent.</value>
        [DataMember(Name = "call_timeout_s", EmitDefaultValue = false)]
        public double CallTimeoutS { get; set; }

        /// <summary>
        /// Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
        /// </summary>
        /// <value>Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.</value>
        [DataMember(Name = "max_concurrent", EmitDefaultValue = false)]
        public int MaxConcurrent { get; set; }

        /// <summary>
        /// How often a call that was not answered is repeated; 3 when absent.
        /// </summary>
        /// <value>How often a call that was not answered is repeated; 3 when absent.</value>
        [DataMember(Name = "max_retries", EmitDefaultValue = false)]
        public int MaxRetries { get; set; }

        /// <summary>
        /// Numbers that a chat completion is asked with, such as &#x60;temperature&#x60; and &#x60;max_tokens&#x60;; for &#x60;openai_chat&#x60; alone.
        /// </summary>
        /// <value>Numbers that a chat completion is asked with, such as &#x60;temperature&#x60; and &#x60;max_tokens&#x60;; for &#x60;openai_chat&#x60; alone.</value>
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
            sb.Append("class PolicyServer {\n");
            sb.Append("  Url: ").Append(Url).Append("\n");
            sb.Append("  Protocol: ").Append(Protocol).Append("\n");
            sb.Append("  ApiKey: ").Append(ApiKey).Append("\n");
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
            // Url (string) maxLength
            if (this.Url != null && this.Url.Length > 500)
            {
                yield return new ValidationResult("Invalid value for Url, length must be less than 500.", new [] { "Url" });
            }

            if (this.Url != null) {
                // Url (string) pattern
                Regex regexUrl = new Regex(@"^https?://[A-Za-z0-9.:_\[\]-]+(/[A-Za-z0-9._~%/-]*)?$", RegexOptions.CultureInvariant);
                if (!regexUrl.Match(this.Url).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for Url, must match a pattern of " + regexUrl, new [] { "Url" });
                }
            }

            // ApiKey (string) maxLength
            if (this.ApiKey != null && this.ApiKey.Length > 4096)
            {
                yield return new ValidationResult("Invalid value for ApiKey, length must be less than 4096.", new [] { "ApiKey" });
            }

            // ApiKey (string) minLength
            if (this.ApiKey != null && this.ApiKey.Length < 1)
            {
                yield return new ValidationResult("Invalid value for ApiKey, length must be greater than 1.", new [] { "ApiKey" });
            }

            if (this.ApiKey != null) {
                // ApiKey (string) pattern
                Regex regexApiKey = new Regex(@"^[!-~]+$", RegexOptions.CultureInvariant);
                if (!regexApiKey.Match(this.ApiKey).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for ApiKey, must match a pattern of " + regexApiKey, new [] { "ApiKey" });
                }
            }

            // Model (string) maxLength
            if (this.Model != null && this.Model.Length > 200)
            {
                yield return new ValidationResult("Invalid value for Model, length must be less than 200.", new [] { "Model" });
            }

            // Model (string) minLength
            if (this.Model != null && this.Model.Length < 1)
            {
                yield return new ValidationResult("Invalid value for Model, length must be greater than 1.", new [] { "Model" });
            }

            // CallTimeoutS (double) maximum
            if (this.CallTimeoutS > (double)600)
            {
                yield return new ValidationResult("Invalid value for CallTimeoutS, must be a value less than or equal to 600.", new [] { "CallTimeoutS" });
            }

            // CallTimeoutS (double) minimum
            if (this.CallTimeoutS < (double)0.1)
            {
                yield return new ValidationResult("Invalid value for CallTimeoutS, must be a value greater than or equal to 0.1.", new [] { "CallTimeoutS" });
            }

            // MaxConcurrent (int) maximum
            if (this.MaxConcurrent > (int)1024)
            {
                yield return new ValidationResult("Invalid value for MaxConcurrent, must be a value less than or equal to 1024.", new [] { "MaxConcurrent" });
            }

            // MaxConcurrent (int) minimum
            if (this.MaxConcurrent < (int)1)
            {
                yield return new ValidationResult("Invalid value for MaxConcurrent, must be a value greater than or equal to 1.", new [] { "MaxConcurrent" });
            }

            // MaxRetries (int) maximum
            if (this.MaxRetries > (int)10)
            {
                yield return new ValidationResult("Invalid value for MaxRetries, must be a value less than or equal to 10.", new [] { "MaxRetries" });
            }

            // MaxRetries (int) minimum
            if (this.MaxRetries < (int)0)
            {
                yield return new ValidationResult("Invalid value for MaxRetries, must be a value greater than or equal to 0.", new [] { "MaxRetries" });
            }

            yield break;
        }
    }

}
