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
    /// Defines ImageCodec
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum ImageCodec
    {
        /// <summary>
        /// Enum Raw for value: raw
        /// </summary>
        [EnumMember(Value = "raw")]
        Raw = 1,

        /// <summary>
        /// Enum Png for value: png
        /// </summary>
        [EnumMember(Value = "png")]
        Png = 2,

        /// <summary>
        /// Enum Jpeg for value: jpeg
        /// </summary>
        [EnumMember(Value = "jpeg")]
        Jpeg = 3
    }

}
