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
    /// &#x60;pull&#x60; when absent: workers attach and predict. &#x60;push&#x60;: the server calls the policy itself, and workers of the run are its own.
    /// </summary>
    /// <value>&#x60;pull&#x60; when absent: workers attach and predict. &#x60;push&#x60;: the server calls the policy itself, and workers of the run are its own.</value>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum RunMode
    {
        /// <summary>
        /// Enum Pull for value: pull
        /// </summary>
        [EnumMember(Value = "pull")]
        Pull = 1,

        /// <summary>
        /// Enum Push for value: push
        /// </summary>
        [EnumMember(Value = "push")]
        Push = 2
    }

}
