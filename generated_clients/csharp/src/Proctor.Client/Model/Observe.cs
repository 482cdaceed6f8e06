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
    /// &#x60;last&#x60; when absent; &#x60;all&#x60; adds the observation after every executed action.
    /// </summary>
    /// <value>&#x60;last&#x60; when absent; &#x60;all&#x60; adds the observation after every executed action.</value>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum Observe
    {
        /// <summary>
        /// Enum Last for value: last
        /// </summary>
        [EnumMember(Value = "last")]
        Last = 1,

        /// <summary>
        /// Enum All for value: all
        /// </summary>
        [EnumMember(Value = "all")]
        All = 2
    }

}
