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
    /// Defines Profile
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum Profile
    {
        /// <summary>
        /// Enum Core for value: core
        /// </summary>
        [EnumMember(Value = "core")]
        Core = 1,

        /// <summary>
        /// Enum Msgpack for value: msgpack
        /// </summary>
        [EnumMember(Value = "msgpack")]
        Msgpack = 2,

        /// <summary>
        /// Enum Compare for value: compare
        /// </summary>
        [EnumMember(Value = "compare")]
        Compare = 3,

        /// <summary>
        /// Enum Events for value: events
        /// </summary>
        [EnumMember(Value = "events")]
        Events = 4,

        /// <summary>
        /// Enum Push for value: push
        /// </summary>
        [EnumMember(Value = "push")]
        Push = 5,

        /// <summary>
        /// Enum Ebench for value: ebench
        /// </summary>
        [EnumMember(Value = "ebench")]
        Ebench = 6,

        /// <summary>
        /// Enum Flageval for value: flageval
        /// </summary>
        [EnumMember(Value = "flageval")]
        Flageval = 7
    }

}
