// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ResetPolicy type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ResetPolicy{}

// ResetPolicy An attempt begins; whatever the policy remembers of this session is over.
type ResetPolicy struct {
	SessionId string `json:"session_id"`
	RunId *string `json:"run_id,omitempty"`
	Benchmark Benchmark `json:"benchmark"`
	Episode EpisodeView `json:"episode"`
	AdditionalProperties map[string]interface{}
}

type _ResetPolicy ResetPolicy

// NewResetPolicy instantiates a new ResetPolicy object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewResetPolicy(sessionId string, benchmark Benchmark, episode EpisodeView) *ResetPolicy {
	this := ResetPolicy{}
	this.SessionId = sessionId
	this.Benchmark = benchmark
	this.Episode = episode
	return &this
}

// NewResetPolicyWithDefaults instantiates a new ResetPolicy object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewResetPolicyWithDefaults() *ResetPolicy {
	this := ResetPolicy{}
	return &this
}

// GetSessionId returns the SessionId field value
func (o *ResetPolicy) GetSessionId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.SessionId
}

// GetSessionIdOk returns a tuple with the SessionId field value
// and a boolean to check if the value has been set.
func (o *ResetPolicy) GetSessionIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SessionId, true
}

// SetSessionId sets field value
func (o *ResetPolicy) SetSessionId(v string) {
	o.SessionId = v
}

// GetRunId returns the RunId field value if set, zero value otherwise.
func (o *ResetPolicy) GetRunId() string {
	if o == nil || IsNil(o.RunId) {
		var ret string
		return ret
	}
	return *o.RunId
}

// GetRunIdOk returns a tuple with the RunId field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *ResetPolicy) GetRunIdOk() (*string, bool) {
	if o == nil || IsNil(o.RunId) {
		return nil, false
	}
	return o.RunId, true
}

// HasRunId returns a boolean if a field has been set.
func (o *ResetPolicy) HasRunId() bool {
	if o != nil && !IsNil(o.RunId) {
		return true
	}

	return false
}

// SetRunId gets a reference to the given string and assigns it to the RunId field.
func (o *ResetPolicy) SetRunId(v string) {
	o.RunId = &v
}

// GetBenchmark returns the Benchmark field value
func (o *ResetPolicy) GetBenchmark() Benchmark {
	if o == nil {
		var ret Benchmark
		return ret
	}

	return o.Benchmark
}

// GetBenchmarkOk returns a tuple with the Benchmark field value
// and a boolean to check if the value has been set.
func (o *ResetPolicy) GetBenchmarkOk() (*Benchmark, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Benchmark, true
}

// SetBenchmark sets field value
func (o *ResetPolicy) SetBenchmark(v Benchmark) {
	o.Benchmark = v
}

// GetEpisode returns the Episode field value
func (o *ResetPolicy) GetEpisode() EpisodeView {
	if o == nil {
		var ret EpisodeView
		return ret
	}

	return o.Episode
}

// GetEpisodeOk returns a tuple with the Episode field value
// and a boolean to check if the value has been set.
func (o *ResetPolicy) GetEpisodeOk() (*EpisodeView, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Episode, true
}

// SetEpisode sets field value
func (o *ResetPolicy) SetEpisode(v EpisodeView) {
	o.Episode = v
}

func (o ResetPolicy) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ResetPolicy) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["session_id"] = o.SessionId
	if !IsNil(o.RunId) {
		toSerialize["run_id"] = o.RunId
	}
	toSerialize["benchmark"] = o.Benchmark
	toSerialize["episode"] = o.Episode

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ResetPolicy) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"session_id",
		"benchmark",
		"episode",
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

	varResetPolicy := _ResetPolicy{}

	err = json.Unmarshal(data, &varResetPolicy)

	if err != nil {
		return err
	}

	*o = ResetPolicy(varResetPolicy)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "session_id")
		delete(additionalProperties, "run_id")
		delete(additionalProperties, "benchmark")
		delete(additionalProperties, "episode")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableResetPolicy struct {
	value *ResetPolicy
	isSet bool
}

func (v NullableResetPolicy) Get() *ResetPolicy {
	return v.value
}

func (v *NullableResetPolicy) Set(val *ResetPolicy) {
	v.value = val
	v.isSet = true
}

func (v NullableResetPolicy) IsSet() bool {
	return v.isSet
}

func (v *NullableResetPolicy) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableResetPolicy(val *ResetPolicy) *NullableResetPolicy {
	return &NullableResetPolicy{value: val, isSet: true}
}

func (v NullableResetPolicy) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableResetPolicy) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
