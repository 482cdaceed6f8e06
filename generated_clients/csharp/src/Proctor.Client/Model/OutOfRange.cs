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
    /// Defines OutOfRange
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum OutOfRange
    {
        /// <summary>
        /// Enum Refuse for value: refuse
        /// </summary>
        [EnumMember(Value = "refuse")]
        Refuse = 1,

        /// <summary>
        /// Enum Clip for value: clip
        /// </summary>
        [EnumMember(Value = "clip")]
        Clip = 2,

        /// <summary>
        /// Enum Unbounded for value: unbounded
        /// </summary>
        [EnumMember(Value = "unbounded")]
        Unbounded = 3
    }

}
