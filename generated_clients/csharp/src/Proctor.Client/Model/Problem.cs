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
    /// RFC 9457, with what a client needs to decide on a retry.
    /// </summary>
    [DataContract(Name = "Problem")]
    public partial class Problem : IValidatableObject
    {

        /// <summary>
        /// Gets or Sets SideEffects
        /// </summary>
        [DataMember(Name = "side_effects", IsRequired = true, EmitDefaultValue = true)]
        public SideEffects SideEffects { get; set; }

        /// <summary>
        /// Gets or Sets State
        /// </summary>
        [DataMember(Name = "state", EmitDefaultValue = false)]
        public RunState? State { get; set; }
        /// <summary>
        /// Initializes a new instance of the <see cref="Problem" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Problem()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Problem" /> class.
        /// </summary>
        /// <param name="type">type (required).</param>
        /// <param name="title">title (required).</param>
        /// <param name="status">status (required).</param>
        /// <param name="detail">What happened and what to do about it. (required).</param>
        /// <param name="code">One of x-problems, or one of a later version. (required).</param>
        /// <param name="retryable">Whether the same request can succeed later. (required).</param>
        /// <param name="sideEffects">sideEffects (required).</param>
        /// <param name="errors">errors.</param>
        /// <param name="requirement">Id of the rule that was enforced..</param>
        /// <param name="state">state.</param>
        /// <param name="expectedSeq">expectedSeq.</param>
        /// <param name="endedBy">What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended..</param>
        public Problem(string type = default, string title = default, int status = default, string detail = default, string code = default, bool retryable = default, SideEffects sideEffects = default, List<ProblemItem> errors = default, string requirement = default, RunState? state = default, long expectedSeq = default, string endedBy = default)
        {
            // to ensure "type" is required (not null)
            if (type == null)
            {
                throw new ArgumentNullException("type is a required property for Problem and cannot be null");
            }
            this.Type = type;
            // to ensure "title" is required (not null)
            if (title == null)
            {
                throw new ArgumentNullException("title is a required property for Problem and cannot be null");
            }
            this.Title = title;
            this.Status = status;
            // to ensure "detail" is required (not null)
            if (detail == null)
            {
                throw new ArgumentNullException("detail is a required property for Problem and cannot be null");
            }
            this.Detail = detail;
            // to ensure "code" is required (not null)
            if (code == null)
            {
                throw new ArgumentNullException("code is a required property for Problem and cannot be null");
            }
            this.Code = code;
            this.Retryable = retryable;
            this.SideEffects = sideEffects;
            this.Errors = errors;
            this.Requirement = requirement;
            this.State = state;
            this.ExpectedSeq = expectedSeq;
            this.EndedBy = endedBy;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Type
        /// </summary>
        [DataMember(Name = "type", IsRequired = true, EmitDefaultValue = true)]
        public string Type { get; set; }

        /// <summary>
        /// Gets or Sets Title
        /// </summary>
        [DataMember(Name = "title", IsRequired = true, EmitDefaultValue = true)]
        public string Title { get; set; }

        /// <summary>
        /// Gets or Sets Status
        /// </summary>
        [DataMember(Name = "status", IsRequired = true, EmitDefaultValue = true)]
        public int Status { get; set; }

        /// <summary>
        /// What happened and what to do about it.
        /// </summary>
        /// <value>What happened and what to do about it.</value>
        [DataMember(Name = "detail", IsRequired = true, EmitDefaultValue = true)]
        public string Detail { get; set; }

        /// <summary>
        /// One of x-problems, or one of a later version.
        /// </summary>
        /// <value>One of x-problems, or one of a later version.</value>
        [DataMember(Name = "code", IsRequired = true, EmitDefaultValue = true)]
        public string Code { get; set; }

        /// <summary>
        /// Whether the same request can succeed later.
        /// </summary>
        /// <value>Whether the same request can succeed later.</value>
        [DataMember(Name = "retryable", IsRequired = true, EmitDefaultValue = true)]
        public bool Retryable { get; set; }

        /// <summary>
        /// Gets or Sets Errors
        /// </summary>
        [DataMember(Name = "errors", EmitDefaultValue = false)]
        public List<ProblemItem> Errors { get; set; }

        /// <summary>
        /// Id of the rule that was enforced.
        /// </summary>
        /// <value>Id of the rule that was enforced.</value>
        [DataMember(Name = "requirement", EmitDefaultValue = false)]
        public string Requirement { get; set; }

        /// <summary>
        /// Gets or Sets ExpectedSeq
        /// </summary>
        [DataMember(Name = "expected_seq", EmitDefaultValue = false)]
        public long ExpectedSeq { get; set; }

        /// <summary>
        /// What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended.
        /// </summary>
        /// <value>What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended.</value>
        [DataMember(Name = "ended_by", EmitDefaultValue = false)]
        public string EndedBy { get; set; }

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
            sb.Append("class Problem {\n");
            sb.Append("  Type: ").Append(Type).Append("\n");
            sb.Append("  Title: ").Append(Title).Append("\n");
            sb.Append("  Status: ").Append(Status).Append("\n");
            sb.Append("  Detail: ").Append(Detail).Append("\n");
            sb.Append("  Code: ").Append(Code).Append("\n");
            sb.Append("  Retryable: ").Append(Retryable).Append("\n");
            sb.Append("  SideEffects: ").Append(SideEffects).Append("\n");
            sb.Append("  Errors: ").Append(Errors).Append("\n");
            sb.Append("  Requirement: ").Append(Requirement).Append("\n");
            sb.Append("  State: ").Append(State).Append("\n");
            sb.Append("  ExpectedSeq: ").Append(ExpectedSeq).Append("\n");
            sb.Append("  EndedBy: ").Append(EndedBy).Append("\n");
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
            // Status (int) maximum
            if (this.Status > (int)599)
            {
                yield return new ValidationResult("Invalid value for Status, must be a value less than or equal to 599.", new [] { "Status" });
            }

            // Status (int) minimum
            if (this.Status < (int)400)
            {
                yield return new ValidationResult("Invalid value for Status, must be a value greater than or equal to 400.", new [] { "Status" });
            }

            // ExpectedSeq (long) minimum
            if (this.ExpectedSeq < (long)1)
            {
                yield return new ValidationResult("Invalid value for ExpectedSeq, must be a value greater than or equal to 1.", new [] { "ExpectedSeq" });
            }

            if (this.EndedBy != null) {
                // EndedBy (string) pattern
                Regex regexEndedBy = new Regex(@"^[a-z][a-z0-9_]{0,63}$", RegexOptions.CultureInvariant);
                if (!regexEndedBy.Match(this.EndedBy).Success)
                {
                    yield return new System.ComponentModel.DataAnnotations.ValidationResult("Invalid value for EndedBy, must match a pattern of " + regexEndedBy, new [] { "EndedBy" });
                }
            }

            yield break;
        }
    }

}
