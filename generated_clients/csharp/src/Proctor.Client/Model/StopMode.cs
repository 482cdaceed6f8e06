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
    /// &#x60;abort&#x60; when absent.
    /// </summary>
    /// <value>&#x60;abort&#x60; when absent.</value>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum StopMode
    {
        /// <summary>
        /// Enum Abort for value: abort
        /// </summary>
        [EnumMember(Value = "abort")]
        Abort = 1,

        /// <summary>
        /// Enum Drain for value: drain
        /// </summary>
        [EnumMember(Value = "drain")]
        Drain = 2
    }

}
