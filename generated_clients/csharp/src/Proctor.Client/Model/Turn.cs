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
    /// The answer to attach (seq 0) and to predict.
    /// </summary>
    [DataContract(Name = "Turn")]
    public partial class Turn : IValidatableObject
    {
        /// <summary>
        /// Initializes a new instance of the <see cref="Turn" /> class.
        /// </summary>
        [JsonConstructorAttribute]
        protected Turn()
        {
            this.AdditionalProperties = new Dictionary<string, object>();
        }
        /// <summary>
        /// Initializes a new instance of the <see cref="Turn" /> class.
        /// </summary>
        /// <param name="sessionId">sessionId (required).</param>
        /// <param name="seq">seq (required).</param>
        /// <param name="episode">episode.</param>
        /// <param name="observation">observation.</param>
        /// <param name="observations">With &#x60;observe&#x60; all, one per executed action..</param>
        /// <param name="executedSteps">executedSteps (required).</param>
        /// <param name="stoppedEarly">The episode ended before the chunk did. (required).</param>
        /// <param name="rewards">One per executed action. (required).</param>
        /// <param name="terminated">The task ended by itself in this turn. (required).</param>
        /// <param name="truncated">The step limit ended the episode in this turn. (required).</param>
        /// <param name="episodeResult">episodeResult.</param>
        /// <param name="fault">fault.</param>
        /// <param name="done">No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends. (required).</param>
        /// <param name="lease">lease (required).</param>
        /// <param name="timing">timing (required).</param>
        public Turn(string sessionId = default, long seq = default, EpisodeView episode = default, Observation observation = default, List<Observation> observations = default, int executedSteps = default, bool stoppedEarly = default, List<double> rewards = default, bool terminated = default, bool truncated = default, EpisodeResult episodeResult = default, Fault fault = default, bool done = default, Lease lease = default, Timing timing = default)
        {
            // to ensure "sessionId" is required (not null)
            if (sessionId == null)
            {
                throw new ArgumentNullException("sessionId is a required property for Turn and cannot be null");
            }
            this.SessionId = sessionId;
            this.Seq = seq;
            this.ExecutedSteps = executedSteps;
            this.StoppedEarly = stoppedEarly;
            // to ensure "rewards" is required (not null)
            if (rewards == null)
            {
                throw new ArgumentNullException("rewards is a required property for Turn and cannot be null");
            }
            this.Rewards = rewards;
            this.Terminated = terminated;
            this.Truncated = truncated;
            this.Done = done;
            // to ensure "lease" is required (not null)
            if (lease == null)
            {
                throw new ArgumentNullException("lease is a required property for Turn and cannot be null");
            }
            this.Lease = lease;
            // to ensure "timing" is required (not null)
            if (timing == null)
            {
                throw new ArgumentNullException("timing is a required property for Turn and cannot be null");
            }
            this.Timing = timing;
            this.Episode = episode;
            this.Observation = observation;
            this.Observations = observations;
            this.EpisodeResult = episodeResult;
            this.Fault = fault;
            this.AdditionalProperties = new Dictionary<string, object>();
        }

        /// <summary>
        /// Gets or Sets SessionId
        /// </summary>
        [DataMember(Name = "session_id", IsRequired = true, EmitDefaultValue = true)]
        public string SessionId { get; set; }

        /// <summary>
        /// Gets or Sets Seq
        /// </summary>
        [DataMember(Name = "seq", IsRequired = true, EmitDefaultValue = true)]
        public long Seq { get; set; }

        /// <summary>
        /// Gets or Sets Episode
        /// </summary>
        [DataMember(Name = "episode", EmitDefaultValue = false)]
        public EpisodeView Episode { get; set; }

        /// <summary>
        /// Gets or Sets Observation
        /// </summary>
        [DataMember(Name = "observation", EmitDefaultValue = false)]
        public Observation Observation { get; set; }

        /// <summary>
        /// With &#x60;observe&#x60; all, one per executed action.
        /// </summary>
        /// <value>With &#x60;observe&#x60; all, one per executed action.</value>
        [DataMember(Name = "observations", EmitDefaultValue = false)]
        public List<Observation> Observations { get; set; }

        /// <summary>
        /// Gets or Sets ExecutedSteps
        /// </summary>
        [DataMember(Name = "executed_steps", IsRequired = true, EmitDefaultValue = true)]
        public int ExecutedSteps { get; set; }

        /// <summary>
        /// The episode ended before the chunk did.
        /// </summary>
        /// <value>The episode ended before the chunk did.</value>
        [DataMember(Name = "stopped_early", IsRequired = true, EmitDefaultValue = true)]
        public bool StoppedEarly { get; set; }

        /// <summary>
        /// One per executed action.
        /// </summary>
        /// <value>One per executed action.</value>
        [DataMember(Name = "rewards", IsRequired = true, EmitDefaultValue = true)]
        public List<double> Rewards { get; set; }

        /// <summary>
        /// The task ended by itself in this turn.
        /// </summary>
        /// <value>The task ended by itself in this turn.</value>
        [DataMember(Name = "terminated", IsRequired = true, EmitDefaultValue = true)]
        public bool Terminated { get; set; }

        /// <summary>
        /// The step limit ended the episode in this turn.
        /// </summary>
        /// <value>The step limit ended the episode in this turn.</value>
        [DataMember(Name = "truncated", IsRequired = true, EmitDefaultValue = true)]
        public bool Truncated { get; set; }

        /// <summary>
        /// Gets or Sets EpisodeResult
        /// </summary>
        [DataMember(Name = "episode_result", EmitDefaultValue = false)]
        public EpisodeResult EpisodeResult { get; set; }

        /// <summary>
        /// Gets or Sets Fault
        /// </summary>
        [DataMember(Name = "fault", EmitDefaultValue = false)]
        public Fault Fault { get; set; }

        /// <summary>
        /// No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
        /// </summary>
        /// <value>No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.</value>
        [DataMember(Name = "done", IsRequired = true, EmitDefaultValue = true)]
        public bool Done { get; set; }

        /// <summary>
        /// Gets or Sets Lease
        /// </summary>
        [DataMember(Name = "lease", IsRequired = true, EmitDefaultValue = true)]
        public Lease Lease { get; set; }

        /// <summary>
        /// Gets or Sets Timing
        /// </summary>
        [DataMember(Name = "timing", IsRequired = true, EmitDefaultValue = true)]
        public Timing Timing { get; set; }

        /// <summary>
        /// Gets or Sets additional properties
        /// </summary>
        [JsonExtensionData]
        public IDictionary<string, object> AdditionalProperties { get; set; }

        /// <summary>
        /// Returns the string presentation of the object
        /// </summary>
        /// <returns>String presentation of the object</returns>
        public override string ToString()
        {
            StringBuilder sb = new StringBuilder();
            sb.Append("class Turn {\n");
            sb.Append("  SessionId: ").Append(SessionId).Append("\n");
            sb.Append("  Seq: ").Append(Seq).Append("\n");
            sb.Append("  Episode: ").Append(Episode).Append("\n");
            sb.Append("  Observation: ").Append(Observation).Append("\n");
            sb.Append("  Observations: ").Append(Observations).Append("\n");
            sb.Append("  ExecutedSteps: ").Append(ExecutedSteps).Append("\n");
            sb.Append("  StoppedEarly: ").Append(StoppedEarly).Append("\n");
            sb.Append("  Rewards: ").Append(Rewards).Append("\n");
            sb.Append("  Terminated: ").Append(Terminated).Append("\n");
            sb.Append("  Truncated: ").Append(Truncated).Append("\n");
            sb.Append("  EpisodeResult: ").Append(EpisodeResult).Append("\n");
            sb.Append("  Fault: ").Append(Fault).Append("\n");
            sb.Append("  Done: ").Append(Done).Append("\n");
            sb.Append("  Lease: ").Append(Lease).Append("\n");
            sb.Append("  Timing: ").Append(Timing).Append("\n");
            sb.Append("  AdditionalProperties: ").Append(AdditionalProperties).Append("\n");
            sb.Append("}\n");
            return sb.ToString();
        }

        /// <summary>
        /// Returns the JSON string presentation of the object
        /// </summary>
        /// <returns>JSON string presentation of the object</returns>
        public virtual string ToJson()
        {
            return Newtonsoft.Json.JsonConvert.SerializeObject(this, Newtonsoft.Json.Formatting.Indented);
        }

        /// <summary>
        /// To validate all properties of the instance
        /// </summary>
        /// <param name="validationContext">Validation context</param>
        /// <returns>Validation Result</returns>
        IEnumerable<ValidationResult> IValidatableObject.Validate(ValidationContext validationContext)
        {
            // Seq (long) minimum
            if (this.Seq < (long)0)
            {
                yield return new ValidationResult("Invalid value for Seq, must be a value greater than or equal to 0.", new [] { "Seq" });
            }

            // ExecutedSteps (int) minimum
            if (this.ExecutedSteps < (int)0)
            {
                yield return new ValidationResult("Invalid value for ExecutedSteps, must be a value greater than or equal to 0.", new [] { "ExecutedSteps" });
            }

            yield break;
        }
    }

}
