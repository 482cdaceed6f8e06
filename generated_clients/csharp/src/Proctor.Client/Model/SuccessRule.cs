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
    /// Defines SuccessRule
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum SuccessRule
    {
        /// <summary>
        /// Enum AnyStep for value: any_step
        /// </summary>
        [EnumMember(Value = "any_step")]
        AnyStep = 1,

        /// <summary>
        /// Enum LastStep for value: last_step
        /// </summary>
        [EnumMember(Value = "last_step")]
        LastStep = 2
    }

}
