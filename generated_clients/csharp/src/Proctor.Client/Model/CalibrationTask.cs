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
    /// Defines CalibrationTask
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum CalibrationTask
    {
        /// <summary>
        /// Enum Score for value: score
        /// </summary>
        [EnumMember(Value = "score")]
        Score = 1,

        /// <summary>
        /// Enum Count for value: count
        /// </summary>
        [EnumMember(Value = "count")]
        Count = 2,

        /// <summary>
        /// Enum Echo for value: echo
        /// </summary>
        [EnumMember(Value = "echo")]
        Echo = 3,

        /// <summary>
        /// Enum Delay for value: delay
        /// </summary>
        [EnumMember(Value = "delay")]
        Delay = 4,

        /// <summary>
        /// Enum Fault for value: fault
        /// </summary>
        [EnumMember(Value = "fault")]
        Fault = 5
    }

}
