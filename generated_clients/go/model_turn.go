// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Turn type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Turn{}

// Turn The answer to attach (seq 0) and to predict.
type Turn struct {
	SessionId string `json:"session_id"`
	Seq int64 `json:"seq"`
	Episode *EpisodeView `json:"episode,omitempty"`
	Observation *Observation `json:"observation,omitempty"`
	// With `observe` all, one per executed action.
	Observations []Observation `json:"observations,omitempty"`
	ExecutedSteps int32 `json:"executed_steps"`
	// The episode ended before the chunk did.
	StoppedEarly bool `json:"stopped_early"`
	// One per executed action.
	Rewards []float64 `json:"rewards"`
	// The task ended by itself in this turn.
	Terminated bool `json:"terminated"`
	// The step limit ended the episode in this turn.
	Truncated bool `json:"truncated"`
	EpisodeResult *EpisodeResult `json:"episode_result,omitempty"`
	Fault *Fault `json:"fault,omitempty"`
	// No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
	Done bool `json:"done"`
	Lease Lease `json:"lease"`
	Timing Timing `json:"timing"`
	AdditionalProperties map[string]interface{}
}

type _Turn Turn

// NewTurn instantiates a new Turn object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewTurn(sessionId string, seq int64, executedSteps int32, stoppedEarly bool, rewards []float64, terminated bool, truncated bool, done bool, lease Lease, timing Timing) *Turn {
	this := Turn{}
	this.SessionId = sessionId
	this.Seq = seq
	this.ExecutedSteps = executedSteps
	this.StoppedEarly = stoppedEarly
	this.Rewards = rewards
	this.Terminated = terminated
	this.Truncated = truncated
	this.Done = done
	this.Lease = lease
	this.Timing = timing
	return &this
}

// NewTurnWithDefaults instantiates a new Turn object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewTurnWithDefaults() *Turn {
	this := Turn{}
	return &this
}

// GetSessionId returns the SessionId field value
func (o *Turn) GetSessionId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.SessionId
}

// GetSessionIdOk returns a tuple with the SessionId field value
// and a boolean to check if the value has been set.
func (o *Turn) GetSessionIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SessionId, true
}

// SetSessionId sets field value
func (o *Turn) SetSessionId(v string) {
	o.SessionId = v
}

// GetSeq returns the Seq field value
func (o *Turn) GetSeq() int64 {
	if o == nil {
		var ret int64
		return ret
	}

	return o.Seq
}

// GetSeqOk returns a tuple with the Seq field value
// and a boolean to check if the value has been set.
func (o *Turn) GetSeqOk() (*int64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Seq, true
}

// SetSeq sets field value
func (o *Turn) SetSeq(v int64) {
	o.Seq = v
}

// GetEpisode returns the Episode field value if set, zero value otherwise.
func (o *Turn) GetEpisode() EpisodeView {
	if o == nil || IsNil(o.Episode) {
		var ret EpisodeView
		return ret
	}
	return *o.Episode
}

// GetEpisodeOk returns a tuple with the Episode field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Turn) GetEpisodeOk() (*EpisodeView, bool) {
	if o == nil || IsNil(o.Episode) {
		return nil, false
	}
	return o.Episode, true
}

// HasEpisode returns a boolean if a field has been set.
func (o *Turn) HasEpisode() bool {
	if o != nil && !IsNil(o.Episode) {
		return true
	}

	return false
}

// SetEpisode gets a reference to the given EpisodeView and assigns it to the Episode field.
func (o *Turn) SetEpisode(v EpisodeView) {
	o.Episode = &v
}

// GetObservation returns the Observation field value if set, zero value otherwise.
func (o *Turn) GetObservation() Observation {
	if o == nil || IsNil(o.Observation) {
		var ret Observation
		return ret
	}
	return *o.Observation
}

// GetObservationOk returns a tuple with the Observation field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Turn) GetObservationOk() (*Observation, bool) {
	if o == nil || IsNil(o.Observation) {
		return nil, false
	}
	return o.Observation, true
}

// HasObservation returns a boolean if a field has been set.
func (o *Turn) HasObservation() bool {
	if o != nil && !IsNil(o.Observation) {
		return true
	}

	return false
}

// SetObservation gets a reference to the given Observation and assigns it to the Observation field.
func (o *Turn) SetObservation(v Observation) {
	o.Observation = &v
}

// GetObservations returns the Observations field value if set, zero value otherwise.
func (o *Turn) GetObservations() []Observation {
	if o == nil || IsNil(o.Observations) {
		var ret []Observation
		return ret
	}
	return o.Observations
}

// GetObservationsOk returns a tuple with the Observations field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Turn) GetObservationsOk() ([]Observation, bool) {
	if o == nil || IsNil(o.Observations) {
		return nil, false
	}
	return o.Observations, true
}

// HasObservations returns a boolean if a field has been set.
func (o *Turn) HasObservations() bool {
	if o != nil && !IsNil(o.Observations) {
		return true
	}

	return false
}

// SetObservations gets a reference to the given []Observation and assigns it to the Observations field.
func (o *Turn) SetObservations(v []Observation) {
	o.Observations = v
}

// GetExecutedSteps returns the ExecutedSteps field value
func (o *Turn) GetExecutedSteps() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.ExecutedSteps
}

// GetExecutedStepsOk returns a tuple with the ExecutedSteps field value
// and a boolean to check if the value has been set.
func (o *Turn) GetExecutedStepsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ExecutedSteps, true
}

// SetExecutedSteps sets field value
func (o *Turn) SetExecutedSteps(v int32) {
	o.ExecutedSteps = v
}

// GetStoppedEarly returns the StoppedEarly field value
func (o *Turn) GetStoppedEarly() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.StoppedEarly
}

// GetStoppedEarlyOk returns a tuple with the StoppedEarly field value
// and a boolean to check if the value has been set.
func (o *Turn) GetStoppedEarlyOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.StoppedEarly, true
}

// SetStoppedEarly sets field value
func (o *Turn) SetStoppedEarly(v bool) {
	o.StoppedEarly = v
}

// GetRewards returns the Rewards field value
func (o *Turn) GetRewards() []float64 {
	if o == nil {
		var ret []float64
		return ret
	}

	return o.Rewards
}

// GetRewardsOk returns a tuple with the Rewards field value
// and a boolean to check if the value has been set.
func (o *Turn) GetRewardsOk() ([]float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Rewards, true
}

// SetRewards sets field value
func (o *Turn) SetRewards(v []float64) {
	o.Rewards = v
}

// GetTerminated returns the Terminated field value
func (o *Turn) GetTerminated() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Terminated
}

// GetTerminatedOk returns a tuple with the Terminated field value
// and a boolean to check if the value has been set.
func (o *Turn) GetTerminatedOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Terminated, true
}

// SetTerminated sets field value
func (o *Turn) SetTerminated(v bool) {
	o.Terminated = v
}

// GetTruncated returns the Truncated field value
func (o *Turn) GetTruncated() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Truncated
}

// GetTruncatedOk returns a tuple with the Truncated field value
// and a boolean to check if the value has been set.
func (o *Turn) GetTruncatedOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Truncated, true
}

// SetTruncated sets field value
func (o *Turn) SetTruncated(v bool) {
	o.Truncated = v
}

// GetEpisodeResult returns the EpisodeResult field value if set, zero value otherwise.
func (o *Turn) GetEpisodeResult() EpisodeResult {
	if o == nil || IsNil(o.EpisodeResult) {
		var ret EpisodeResult
		return ret
	}
	return *o.EpisodeResult
}

// GetEpisodeResultOk returns a tuple with the EpisodeResult field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Turn) GetEpisodeResultOk() (*EpisodeResult, bool) {
	if o == nil || IsNil(o.EpisodeResult) {
		return nil, false
	}
	return o.EpisodeResult, true
}

// HasEpisodeResult returns a boolean if a field has been set.
func (o *Turn) HasEpisodeResult() bool {
	if o != nil && !IsNil(o.EpisodeResult) {
		return true
	}

	return false
}

// SetEpisodeResult gets a reference to the given EpisodeResult and assigns it to the EpisodeResult field.
func (o *Turn) SetEpisodeResult(v EpisodeResult) {
	o.EpisodeResult = &v
}

// GetFault returns the Fault field value if set, zero value otherwise.
func (o *Turn) GetFault() Fault {
	if o == nil || IsNil(o.Fault) {
		var ret Fault
		return ret
	}
	return *o.Fault
}

// GetFaultOk returns a tuple with the Fault field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Turn) GetFaultOk() (*Fault, bool) {
	if o == nil || IsNil(o.Fault) {
		return nil, false
	}
	return o.Fault, true
}

// HasFault returns a boolean if a field has been set.
func (o *Turn) HasFault() bool {
	if o != nil && !IsNil(o.Fault) {
		return true
	}

	return false
}

// SetFault gets a reference to the given Fault and assigns it to the Fault field.
func (o *Turn) SetFault(v Fault) {
	o.Fault = &v
}

// GetDone returns the Done field value
func (o *Turn) GetDone() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Done
}

// GetDoneOk returns a tuple with the Done field value
// and a boolean to check if the value has been set.
func (o *Turn) GetDoneOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Done, true
}

// SetDone sets field value
func (o *Turn) SetDone(v bool) {
	o.Done = v
}

// GetLease returns the Lease field value
func (o *Turn) GetLease() Lease {
	if o == nil {
		var ret Lease
		return ret
	}

	return o.Lease
}

// GetLeaseOk returns a tuple with the Lease field value
// and a boolean to check if the value has been set.
func (o *Turn) GetLeaseOk() (*Lease, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Lease, true
}

// SetLease sets field value
func (o *Turn) SetLease(v Lease) {
	o.Lease = v
}

// GetTiming returns the Timing field value
func (o *Turn) GetTiming() Timing {
	if o == nil {
		var ret Timing
		return ret
	}

	return o.Timing
}

// GetTimingOk returns a tuple with the Timing field value
// and a boolean to check if the value has been set.
func (o *Turn) GetTimingOk() (*Timing, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Timing, true
}

// SetTiming sets field value
func (o *Turn) SetTiming(v Timing) {
	o.Timing = v
}

func (o Turn) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Turn) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["session_id"] = o.SessionId
	toSerialize["seq"] = o.Seq
	if !IsNil(o.Episode) {
		toSerialize["episode"] = o.Episode
	}
	if !IsNil(o.Observation) {
		toSerialize["observation"] = o.Observation
	}
	if !IsNil(o.Observations) {
		toSerialize["observations"] = o.Observations
	}
	toSerialize["executed_steps"] = o.ExecutedSteps
	toSerialize["stopped_early"] = o.StoppedEarly
	toSerialize["rewards"] = o.Rewards
	toSerialize["terminated"] = o.Terminated
	toSerialize["truncated"] = o.Truncated
	if !IsNil(o.EpisodeResult) {
		toSerialize["episode_result"] = o.EpisodeResult
	}
	if !IsNil(o.Fault) {
		toSerialize["fault"] = o.Fault
	}
	toSerialize["done"] = o.Done
	toSerialize["lease"] = o.Lease
	toSerialize["timing"] = o.Timing

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Turn) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"session_id",
		"seq",
		"executed_steps",
		"stopped_early",
		"rewards",
		"terminated",
		"truncated",
		"done",
		"lease",
		"timing",
	}

	allProperties := make(map[string]interface{})

	err = json.Unmarshal(data, &allProperties)

	if err != nil {
		return err;
	}

	for _, requiredProperty := range(requiredProperties) {
		if _, exists := allProperties[requiredProperty]; !exists {
			return fmt.Errorf("no value given for required property %v", requiredProperty)
		}
	}

	varTurn := _Turn{}

	err = json.Unmarshal(data, &varTurn)

	if err != nil {
		return err
	}

	*o = Turn(varTurn)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "session_id")
		delete(additionalProperties, "seq")
		delete(additionalProperties, "episode")
		delete(additionalProperties, "observation")
		delete(additionalProperties, "observations")
		delete(additionalProperties, "executed_steps")
		delete(additionalProperties, "stopped_early")
		delete(additionalProperties, "rewards")
		delete(additionalProperties, "terminated")
		delete(additionalProperties, "truncated")
		delete(additionalProperties, "episode_result")
		delete(additionalProperties, "fault")
		delete(additionalProperties, "done")
		delete(additionalProperties, "lease")
		delete(additionalProperties, "timing")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableTurn struct {
	value *Turn
	isSet bool
}

func (v NullableTurn) Get() *Turn {
	return v.value
}

func (v *NullableTurn) Set(val *Turn) {
	v.value = val
	v.isSet = true
}

func (v NullableTurn) IsSet() bool {
	return v.isSet
}

func (v *NullableTurn) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableTurn(val *Turn) *NullableTurn {
	return &NullableTurn{value: val, isSet: true}
}

func (v NullableTurn) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableTurn) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
