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
    /// Defines EpisodeStatus
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum EpisodeStatus
    {
        /// <summary>
        /// Enum Pending for value: pending
        /// </summary>
        [EnumMember(Value = "pending")]
        Pending = 1,

        /// <summary>
        /// Enum InProgress for value: in_progress
        /// </summary>
        [EnumMember(Value = "in_progress")]
        InProgress = 2,

        /// <summary>
        /// Enum Scored for value: scored
        /// </summary>
        [EnumMember(Value = "scored")]
        Scored = 3
    }

}
