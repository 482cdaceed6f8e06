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
    /// Defines RunState
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum RunState
    {
        /// <summary>
        /// Enum Queued for value: queued
        /// </summary>
        [EnumMember(Value = "queued")]
        Queued = 1,

        /// <summary>
        /// Enum Ready for value: ready
        /// </summary>
        [EnumMember(Value = "ready")]
        Ready = 2,

        /// <summary>
        /// Enum Running for value: running
        /// </summary>
        [EnumMember(Value = "running")]
        Running = 3,

        /// <summary>
        /// Enum Stopping for value: stopping
        /// </summary>
        [EnumMember(Value = "stopping")]
        Stopping = 4,

        /// <summary>
        /// Enum Stopped for value: stopped
        /// </summary>
        [EnumMember(Value = "stopped")]
        Stopped = 5,

        /// <summary>
        /// Enum Failed for value: failed
        /// </summary>
        [EnumMember(Value = "failed")]
        Failed = 6,

        /// <summary>
        /// Enum Completed for value: completed
        /// </summary>
        [EnumMember(Value = "completed")]
        Completed = 7
    }

}
