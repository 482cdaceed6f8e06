// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Episode type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Episode{}

// Episode struct for Episode
type Episode struct {
	EpisodeId string `json:"episode_id"`
	Index int32 `json:"index"`
	Task string `json:"task"`
	Split string `json:"split"`
	Status EpisodeStatus `json:"status"`
	// The current or next attempt.
	Attempt int32 `json:"attempt"`
	Faults int32 `json:"faults"`
	// In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode.
	PolicyFault *string `json:"policy_fault,omitempty"`
	Result *EpisodeResult `json:"result,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _Episode Episode

// NewEpisode instantiates a new Episode object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewEpisode(episodeId string, index int32, task string, split string, status EpisodeStatus, attempt int32, faults int32) *Episode {
	this := Episode{}
	this.EpisodeId = episodeId
	this.Index = index
	this.Task = task
	this.Split = split
	this.Status = status
	this.Attempt = attempt
	this.Faults = faults
	return &this
}

// NewEpisodeWithDefaults instantiates a new Episode object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewEpisodeWithDefaults() *Episode {
	this := Episode{}
	return &this
}

// GetEpisodeId returns the EpisodeId field value
func (o *Episode) GetEpisodeId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.EpisodeId
}

// GetEpisodeIdOk returns a tuple with the EpisodeId field value
// and a boolean to check if the value has been set.
func (o *Episode) GetEpisodeIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodeId, true
}

// SetEpisodeId sets field value
func (o *Episode) SetEpisodeId(v string) {
	o.EpisodeId = v
}

// GetIndex returns the Index field value
func (o *Episode) GetIndex() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Index
}

// GetIndexOk returns a tuple with the Index field value
// and a boolean to check if the value has been set.
func (o *Episode) GetIndexOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Index, true
}

// SetIndex sets field value
func (o *Episode) SetIndex(v int32) {
	o.Index = v
}

// GetTask returns the Task field value
func (o *Episode) GetTask() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Task
}

// GetTaskOk returns a tuple with the Task field value
// and a boolean to check if the value has been set.
func (o *Episode) GetTaskOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Task, true
}

// SetTask sets field value
func (o *Episode) SetTask(v string) {
	o.Task = v
}

// GetSplit returns the Split field value
func (o *Episode) GetSplit() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Split
}

// GetSplitOk returns a tuple with the Split field value
// and a boolean to check if the value has been set.
func (o *Episode) GetSplitOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Split, true
}

// SetSplit sets field value
func (o *Episode) SetSplit(v string) {
	o.Split = v
}

// GetStatus returns the Status field value
func (o *Episode) GetStatus() EpisodeStatus {
	if o == nil {
		var ret EpisodeStatus
		return ret
	}

	return o.Status
}

// GetStatusOk returns a tuple with the Status field value
// and a boolean to check if the value has been set.
func (o *Episode) GetStatusOk() (*EpisodeStatus, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Status, true
}

// SetStatus sets field value
func (o *Episode) SetStatus(v EpisodeStatus) {
	o.Status = v
}

// GetAttempt returns the Attempt field value
func (o *Episode) GetAttempt() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Attempt
}

// GetAttemptOk returns a tuple with the Attempt field value
// and a boolean to check if the value has been set.
func (o *Episode) GetAttemptOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Attempt, true
}

// SetAttempt sets field value
func (o *Episode) SetAttempt(v int32) {
	o.Attempt = v
}

// GetFaults returns the Faults field value
func (o *Episode) GetFaults() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Faults
}

// GetFaultsOk returns a tuple with the Faults field value
// and a boolean to check if the value has been set.
func (o *Episode) GetFaultsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Faults, true
}

// SetFaults sets field value
func (o *Episode) SetFaults(v int32) {
	o.Faults = v
}

// GetPolicyFault returns the PolicyFault field value if set, zero value otherwise.
func (o *Episode) GetPolicyFault() string {
	if o == nil || IsNil(o.PolicyFault) {
		var ret string
		return ret
	}
	return *o.PolicyFault
}

// GetPolicyFaultOk returns a tuple with the PolicyFault field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Episode) GetPolicyFaultOk() (*string, bool) {
	if o == nil || IsNil(o.PolicyFault) {
		return nil, false
	}
	return o.PolicyFault, true
}

// HasPolicyFault returns a boolean if a field has been set.
func (o *Episode) HasPolicyFault() bool {
	if o != nil && !IsNil(o.PolicyFault) {
		return true
	}

	return false
}

// SetPolicyFault gets a reference to the given string and assigns it to the PolicyFault field.
func (o *Episode) SetPolicyFault(v string) {
	o.PolicyFault = &v
}

// GetResult returns the Result field value if set, zero value otherwise.
func (o *Episode) GetResult() EpisodeResult {
	if o == nil || IsNil(o.Result) {
		var ret EpisodeResult
		return ret
	}
	return *o.Result
}

// GetResultOk returns a tuple with the Result field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Episode) GetResultOk() (*EpisodeResult, bool) {
	if o == nil || IsNil(o.Result) {
		return nil, false
	}
	return o.Result, true
}

// HasResult returns a boolean if a field has been set.
func (o *Episode) HasResult() bool {
	if o != nil && !IsNil(o.Result) {
		return true
	}

	return false
}

// SetResult gets a reference to the given EpisodeResult and assigns it to the Result field.
func (o *Episode) SetResult(v EpisodeResult) {
	o.Result = &v
}

func (o Episode) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Episode) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["episode_id"] = o.EpisodeId
	toSerialize["index"] = o.Index
	toSerialize["task"] = o.Task
	toSerialize["split"] = o.Split
	toSerialize["status"] = o.Status
	toSerialize["attempt"] = o.Attempt
	toSerialize["faults"] = o.Faults
	if !IsNil(o.PolicyFault) {
		toSerialize["policy_fault"] = o.PolicyFault
	}
	if !IsNil(o.Result) {
		toSerialize["result"] = o.Result
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Episode) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"episode_id",
		"index",
		"task",
		"split",
		"status",
		"attempt",
		"faults",
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

	varEpisode := _Episode{}

	err = json.Unmarshal(data, &varEpisode)

	if err != nil {
		return err
	}

	*o = Episode(varEpisode)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "episode_id")
		delete(additionalProperties, "index")
		delete(additionalProperties, "task")
		delete(additionalProperties, "split")
		delete(additionalProperties, "status")
		delete(additionalProperties, "attempt")
		delete(additionalProperties, "faults")
		delete(additionalProperties, "policy_fault")
		delete(additionalProperties, "result")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableEpisode struct {
	value *Episode
	isSet bool
}

func (v NullableEpisode) Get() *Episode {
	return v.value
}

func (v *NullableEpisode) Set(val *Episode) {
	v.value = val
	v.isSet = true
}

func (v NullableEpisode) IsSet() bool {
	return v.isSet
}

func (v *NullableEpisode) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableEpisode(val *Episode) *NullableEpisode {
	return &NullableEpisode{value: val, isSet: true}
}

func (v NullableEpisode) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableEpisode) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
