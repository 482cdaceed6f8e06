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
    /// What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended.
    /// </summary>
    /// <value>What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended.</value>
    [JsonConverter(typeof(StringEnumConverter))]
    public enum SessionEnd
    {
        /// <summary>
        /// Enum LeaseEnded for value: lease_ended
        /// </summary>
        [EnumMember(Value = "lease_ended")]
        LeaseEnded = 1,

        /// <summary>
        /// Enum Detached for value: detached
        /// </summary>
        [EnumMember(Value = "detached")]
        Detached = 2,

        /// <summary>
        /// Enum RunStopped for value: run_stopped
        /// </summary>
        [EnumMember(Value = "run_stopped")]
        RunStopped = 3,

        /// <summary>
        /// Enum RunFailed for value: run_failed
        /// </summary>
        [EnumMember(Value = "run_failed")]
        RunFailed = 4,

        /// <summary>
        /// Enum Unknown for value: unknown
        /// </summary>
        [EnumMember(Value = "unknown")]
        Unknown = 5
    }

}
