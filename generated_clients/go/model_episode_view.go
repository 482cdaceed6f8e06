// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the EpisodeView type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &EpisodeView{}

// EpisodeView The episode that the observation belongs to.
type EpisodeView struct {
	EpisodeId string `json:"episode_id"`
	// Position in the manifest.
	Index int32 `json:"index"`
	Task string `json:"task"`
	Instruction string `json:"instruction"`
	Attempt int32 `json:"attempt"`
	Step int32 `json:"step"`
	MaxSteps int32 `json:"max_steps"`
	AdditionalProperties map[string]interface{}
}

type _EpisodeView EpisodeView

// NewEpisodeView instantiates a new EpisodeView object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewEpisodeView(episodeId string, index int32, task string, instruction string, attempt int32, step int32, maxSteps int32) *EpisodeView {
	this := EpisodeView{}
	this.EpisodeId = episodeId
	this.Index = index
	this.Task = task
	this.Instruction = instruction
	this.Attempt = attempt
	this.Step = step
	this.MaxSteps = maxSteps
	return &this
}

// NewEpisodeViewWithDefaults instantiates a new EpisodeView object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewEpisodeViewWithDefaults() *EpisodeView {
	this := EpisodeView{}
	return &this
}

// GetEpisodeId returns the EpisodeId field value
func (o *EpisodeView) GetEpisodeId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.EpisodeId
}

// GetEpisodeIdOk returns a tuple with the EpisodeId field value
// and a boolean to check if the value has been set.
func (o *EpisodeView) GetEpisodeIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodeId, true
}

// SetEpisodeId sets field value
func (o *EpisodeView) SetEpisodeId(v string) {
	o.EpisodeId = v
}

// GetIndex returns the Index field value
func (o *EpisodeView) GetIndex() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Index
}

// GetIndexOk returns a tuple with the Index field value
// and a boolean to check if the value has been set.
func (o *EpisodeView) GetIndexOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Index, true
}

// SetIndex sets field value
func (o *EpisodeView) SetIndex(v int32) {
	o.Index = v
}

// GetTask returns the Task field value
func (o *EpisodeView) GetTask() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Task
}

// GetTaskOk returns a tuple with the Task field value
// and a boolean to check if the value has been set.
func (o *EpisodeView) GetTaskOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Task, true
}

// SetTask sets field value
func (o *EpisodeView) SetTask(v string) {
	o.Task = v
}

// GetInstruction returns the Instruction field value
func (o *EpisodeView) GetInstruction() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Instruction
}

// GetInstructionOk returns a tuple with the Instruction field value
// and a boolean to check if the value has been set.
func (o *EpisodeView) GetInstructionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Instruction, true
}

// SetInstruction sets field value
func (o *EpisodeView) SetInstruction(v string) {
	o.Instruction = v
}

// GetAttempt returns the Attempt field value
func (o *EpisodeView) GetAttempt() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Attempt
}

// GetAttemptOk returns a tuple with the Attempt field value
// and a boolean to check if the value has been set.
func (o *EpisodeView) GetAttemptOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Attempt, true
}

// SetAttempt sets field value
func (o *EpisodeView) SetAttempt(v int32) {
	o.Attempt = v
}

// GetStep returns the Step field value
func (o *EpisodeView) GetStep() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Step
}

// GetStepOk returns a tuple with the Step field value
// and a boolean to check if the value has been set.
func (o *EpisodeView) GetStepOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Step, true
}

// SetStep sets field value
func (o *EpisodeView) SetStep(v int32) {
	o.Step = v
}

// GetMaxSteps returns the MaxSteps field value
func (o *EpisodeView) GetMaxSteps() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxSteps
}

// GetMaxStepsOk returns a tuple with the MaxSteps field value
// and a boolean to check if the value has been set.
func (o *EpisodeView) GetMaxStepsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxSteps, true
}

// SetMaxSteps sets field value
func (o *EpisodeView) SetMaxSteps(v int32) {
	o.MaxSteps = v
}

func (o EpisodeView) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o EpisodeView) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["episode_id"] = o.EpisodeId
	toSerialize["index"] = o.Index
	toSerialize["task"] = o.Task
	toSerialize["instruction"] = o.Instruction
	toSerialize["attempt"] = o.Attempt
	toSerialize["step"] = o.Step
	toSerialize["max_steps"] = o.MaxSteps

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *EpisodeView) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"episode_id",
		"index",
		"task",
		"instruction",
		"attempt",
		"step",
		"max_steps",
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

	varEpisodeView := _EpisodeView{}

	err = json.Unmarshal(data, &varEpisodeView)

	if err != nil {
		return err
	}

	*o = EpisodeView(varEpisodeView)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "episode_id")
		delete(additionalProperties, "index")
		delete(additionalProperties, "task")
		delete(additionalProperties, "instruction")
		delete(additionalProperties, "attempt")
		delete(additionalProperties, "step")
		delete(additionalProperties, "max_steps")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableEpisodeView struct {
	value *EpisodeView
	isSet bool
}

func (v NullableEpisodeView) Get() *EpisodeView {
	return v.value
}

func (v *NullableEpisodeView) Set(val *EpisodeView) {
	v.value = val
	v.isSet = true
}

func (v NullableEpisodeView) IsSet() bool {
	return v.isSet
}

func (v *NullableEpisodeView) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableEpisodeView(val *EpisodeView) *NullableEpisodeView {
	return &NullableEpisodeView{value: val, isSet: true}
}

func (v NullableEpisodeView) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableEpisodeView) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
