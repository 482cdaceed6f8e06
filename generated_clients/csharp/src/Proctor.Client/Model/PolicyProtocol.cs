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
    /// &#x60;proctor&#x60; is policy.yaml. &#x60;openai_chat&#x60; asks for a chat completion at &#x60;chat/completions&#x60; below the URL, for benchmarks that are answered in words.
    /// </summary>
    /// <value>&#x60;proctor&#x60; is policy.yaml. &#x60;openai_chat&#x60; asks for a chat completion at &#x60;chat/completions&#x60; below the URL, for benchmarks that are answered in words.</value>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum PolicyProtocol
    {
        /// <summary>
        /// Enum Proctor for value: proctor
        /// </summary>
        [EnumMember(Value = "proctor")]
        Proctor = 1,

        /// <summary>
        /// Enum OpenaiChat for value: openai_chat
        /// </summary>
        [EnumMember(Value = "openai_chat")]
        OpenaiChat = 2
    }

}
