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
    /// Defines SideEffects
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum SideEffects
    {
        /// <summary>
        /// Enum None for value: none
        /// </summary>
        [EnumMember(Value = "none")]
        None = 1,

        /// <summary>
        /// Enum Possible for value: possible
        /// </summary>
        [EnumMember(Value = "possible")]
        Possible = 2
    }

}
