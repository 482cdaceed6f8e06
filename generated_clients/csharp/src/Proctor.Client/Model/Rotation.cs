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
    /// Defines Rotation
    /// </summary>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum Rotation
    {
        /// <summary>
        /// Enum None for value: none
        /// </summary>
        [EnumMember(Value = "none")]
        None = 1,

        /// <summary>
        /// Enum QuaternionWxyz for value: quaternion_wxyz
        /// </summary>
        [EnumMember(Value = "quaternion_wxyz")]
        QuaternionWxyz = 2,

        /// <summary>
        /// Enum QuaternionXyzw for value: quaternion_xyzw
        /// </summary>
        [EnumMember(Value = "quaternion_xyzw")]
        QuaternionXyzw = 3,

        /// <summary>
        /// Enum AxisAngle for value: axis_angle
        /// </summary>
        [EnumMember(Value = "axis_angle")]
        AxisAngle = 4,

        /// <summary>
        /// Enum EulerXyz for value: euler_xyz
        /// </summary>
        [EnumMember(Value = "euler_xyz")]
        EulerXyz = 5,

        /// <summary>
        /// Enum Rot6dColumns for value: rot6d_columns
        /// </summary>
        [EnumMember(Value = "rot6d_columns")]
        Rot6dColumns = 6
    }

}
