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
    /// What a server says of itself before anyone authenticates.
    /// </summary>
    [DataContract(Name = "Service")]
    public partial class Service : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Service" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Service()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Service" /> class.
        /// </summary>
        /// <param name="name">name (required).</param>
        /// <param name="varVersion">Version of the server software. (required).</param>
        /// <param name="protocol">protocol (required).</param>
        /// <param name="profiles">Parts of the protocol offered; &#x60;core&#x60; may be left out, for it always is. An operation with &#x60;x-profile&#x60; is there when its profile is announced. The rules of the profile &#x60;crash&#x60; are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them, and its report says that they were not verified. (required).</param>
        /// <param name="limits">limits (required).</param>
        /// <param name="encodings">Media types of the data plane. (required).</param>
        /// <param name="imageCodecs">imageCodecs (required).</param>
        /// <param name="serverTime">The server&#39;s clock, UTC. (required).</param>
        public Service(string name = default, string varVersion = default, ProtocolRange protocol = default, List<string> profiles = default, Limits limits = default, List<string> encodings = default, List<string> imageCodecs = default, DateTime serverTime = default)
        {
            // to ensure "name" is required (not null)
            if (name == null)
            {
                throw new ArgumentNullException("name is a required property for Service and cannot be null");
            }
            this.Name = name;
            // to ensure "varVersion" is required (not null)
            if (varVersion == null)
            {
                throw new ArgumentNullException("varVersion is a required property for Service and cannot be null");
            }
            this.VarVersion = varVersion;
            // to ensure "protocol" is required (not null)
            if (protocol == null)
            {
                throw new ArgumentNullException("protocol is a required property for Service and cannot be null");
            }
            this.Protocol = protocol;
            // to ensure "profiles" is required (not null)
            if (profiles == null)
            {
                throw new ArgumentNullException("profiles is a required property for Service and cannot be null");
            }
            this.Profiles = profiles;
            // to ensure "limits" is required (not null)
            if (limits == null)
            {
                throw new ArgumentNullException("limits is a required property for Service and cannot be null");
            }
            this.Limits = limits;
            // to ensure "encodings" is required (not null)
            if (encodings == null)
            {
                throw new ArgumentNullException("encodings is a required property for Service and cannot be null");
            }
            this.Encodings = encodings;
            // to ensure "imageCodecs" is required (not null)
            if (imageCodecs == null)
            {
                throw new ArgumentNullException("imageCodecs is a required property for Service and cannot be null");
            }
            this.ImageCodecs = imageCodecs;
            this.ServerTime = serverTime;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets Name
        /// </summary>
        [DataMember(Name = "name", IsRequired = true, EmitDefaultValue = true)]
        public string Name { get; set; }

        /// <summary>
        /// Version of the server software.
        /// </summary>
        /// <value>Version of the server software.</value>
        [DataMember(Name = "version", IsRequired = true, EmitDefaultValue = true)]
        public string VarVersion { get; set; }

        /// <summary>
        /// Gets or Sets Protocol
        /// </summary>
        [DataMember(Name = "protocol", IsRequired = true, EmitDefaultValue = true)]
        public ProtocolRange Protocol { get; set; }

        /// <summary>
        /// Parts of the protocol offered; &#x60;core&#x60; may be left out, for it always is. An operation with &#x60;x-profile&#x60; is there when its profile is announced. The rules of the profile &#x60;crash&#x60; are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them, and its report says that they were not verified.
        /// </summary>
        /// <value>Parts of the protocol offered; &#x60;core&#x60; may be left out, for it always is. An operation with &#x60;x-profile&#x60; is there when its profile is announced. The rules of the profile &#x60;crash&#x60; are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them, and its report says that they were not verified.</value>
        [DataMember(Name = "profiles", IsRequired = true, EmitDefaultValue = true)]
        public List<string> Profiles { get; set; }

        /// <summary>
        /// Gets or Sets Limits
        /// </summary>
        [DataMember(Name = "limits", IsRequired = true, EmitDefaultValue = true)]
        public Limits Limits { get; set; }

        /// <summary>
        /// Media types of the data plane.
        /// </summary>
        /// <value>Media types of the data plane.</value>
        [DataMember(Name = "encodings", IsRequired = true, EmitDefaultValue = true)]
        public List<string> Encodings { get; set; }

        /// <summary>
        /// Gets or Sets ImageCodecs
        /// </summary>
        [DataMember(Name = "image_codecs", IsRequired = true, EmitDefaultValue = true)]
        public List<string> ImageCodecs { get; set; }

        /// <summary>
        /// The server&#39;s clock, UTC.
        /// </summary>
        /// <value>The server&#39;s clock, UTC.</value>
        [DataMember(Name = "server_time", IsRequired = true, EmitDefaultValue = true)]
        public DateTime ServerTime { get; set; }

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
            sb.Append("class Service {\n");
            sb.Append("  Name: ").Append(Name).Append("\n");
            sb.Append("  VarVersion: ").Append(VarVersion).Append("\n");
            sb.Append("  Protocol: ").Append(Protocol).Append("\n");
            sb.Append("  Profiles: ").Append(Profiles).Append("\n");
            sb.Append("  Limits: ").Append(Limits).Append("\n");
            sb.Append("  Encodings: ").Append(Encodings).Append("\n");
            sb.Append("  ImageCodecs: ").Append(ImageCodecs).Append("\n");
            sb.Append("  ServerTime: ").Append(ServerTime).Append("\n");
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
