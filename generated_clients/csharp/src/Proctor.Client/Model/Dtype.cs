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
    /// Defines Dtype
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum Dtype
    {
        /// <summary>
        /// Enum Bool for value: bool
        /// </summary>
        [EnumMember(Value = "bool")]
        Bool = 1,

        /// <summary>
        /// Enum Int8 for value: int8
        /// </summary>
        [EnumMember(Value = "int8")]
        Int8 = 2,

        /// <summary>
        /// Enum Int16 for value: int16
        /// </summary>
        [EnumMember(Value = "int16")]
        Int16 = 3,

        /// <summary>
        /// Enum Int32 for value: int32
        /// </summary>
        [EnumMember(Value = "int32")]
        Int32 = 4,

        /// <summary>
        /// Enum Int64 for value: int64
        /// </summary>
        [EnumMember(Value = "int64")]
        Int64 = 5,

        /// <summary>
        /// Enum Uint8 for value: uint8
        /// </summary>
        [EnumMember(Value = "uint8")]
        Uint8 = 6,

        /// <summary>
        /// Enum Uint16 for value: uint16
        /// </summary>
        [EnumMember(Value = "uint16")]
        Uint16 = 7,

        /// <summary>
        /// Enum Uint32 for value: uint32
        /// </summary>
        [EnumMember(Value = "uint32")]
        Uint32 = 8,

        /// <summary>
        /// Enum Uint64 for value: uint64
        /// </summary>
        [EnumMember(Value = "uint64")]
        Uint64 = 9,

        /// <summary>
        /// Enum Float16 for value: float16
        /// </summary>
        [EnumMember(Value = "float16")]
        Float16 = 10,

        /// <summary>
        /// Enum Float32 for value: float32
        /// </summary>
        [EnumMember(Value = "float32")]
        Float32 = 11,

        /// <summary>
        /// Enum Float64 for value: float64
        /// </summary>
        [EnumMember(Value = "float64")]
        Float64 = 12
    }

}
