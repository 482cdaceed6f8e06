// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"time"
	"fmt"
)

// checks if the EpisodeResult type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &EpisodeResult{}

// EpisodeResult struct for EpisodeResult
type EpisodeResult struct {
	EpisodeId string `json:"episode_id"`
	Index int32 `json:"index"`
	Task string `json:"task"`
	Split string `json:"split"`
	Seed int64 `json:"seed"`
	Attempt int32 `json:"attempt"`
	Faults int32 `json:"faults"`
	Outcome Outcome `json:"outcome"`
	Score float64 `json:"score"`
	Steps int32 `json:"steps"`
	Terminated bool `json:"terminated"`
	Truncated bool `json:"truncated"`
	// Time between turns that the policy took.
	ThinkS float64 `json:"think_s"`
	FinishedAt time.Time `json:"finished_at"`
	AdditionalProperties map[string]interface{}
}

type _EpisodeResult EpisodeResult

// NewEpisodeResult instantiates a new EpisodeResult object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewEpisodeResult(episodeId string, index int32, task string, split string, seed int64, attempt int32, faults int32, outcome Outcome, score float64, steps int32, terminated bool, truncated bool, thinkS float64, finishedAt time.Time) *EpisodeResult {
	this := EpisodeResult{}
	this.EpisodeId = episodeId
	this.Index = index
	this.Task = task
	this.Split = split
	this.Seed = seed
	this.Attempt = attempt
	this.Faults = faults
	this.Outcome = outcome
	this.Score = score
	this.Steps = steps
	this.Terminated = terminated
	this.Truncated = truncated
	this.ThinkS = thinkS
	this.FinishedAt = finishedAt
	return &this
}

// NewEpisodeResultWithDefaults instantiates a new EpisodeResult object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewEpisodeResultWithDefaults() *EpisodeResult {
	this := EpisodeResult{}
	return &this
}

// GetEpisodeId returns the EpisodeId field value
func (o *EpisodeResult) GetEpisodeId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.EpisodeId
}

// GetEpisodeIdOk returns a tuple with the EpisodeId field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetEpisodeIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodeId, true
}

// SetEpisodeId sets field value
func (o *EpisodeResult) SetEpisodeId(v string) {
	o.EpisodeId = v
}

// GetIndex returns the Index field value
func (o *EpisodeResult) GetIndex() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Index
}

// GetIndexOk returns a tuple with the Index field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetIndexOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Index, true
}

// SetIndex sets field value
func (o *EpisodeResult) SetIndex(v int32) {
	o.Index = v
}

// GetTask returns the Task field value
func (o *EpisodeResult) GetTask() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Task
}

// GetTaskOk returns a tuple with the Task field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetTaskOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Task, true
}

// SetTask sets field value
func (o *EpisodeResult) SetTask(v string) {
	o.Task = v
}

// GetSplit returns the Split field value
func (o *EpisodeResult) GetSplit() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Split
}

// GetSplitOk returns a tuple with the Split field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetSplitOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Split, true
}

// SetSplit sets field value
func (o *EpisodeResult) SetSplit(v string) {
	o.Split = v
}

// GetSeed returns the Seed field value
func (o *EpisodeResult) GetSeed() int64 {
	if o == nil {
		var ret int64
		return ret
	}

	return o.Seed
}

// GetSeedOk returns a tuple with the Seed field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetSeedOk() (*int64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Seed, true
}

// SetSeed sets field value
func (o *EpisodeResult) SetSeed(v int64) {
	o.Seed = v
}

// GetAttempt returns the Attempt field value
func (o *EpisodeResult) GetAttempt() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Attempt
}

// GetAttemptOk returns a tuple with the Attempt field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetAttemptOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Attempt, true
}

// SetAttempt sets field value
func (o *EpisodeResult) SetAttempt(v int32) {
	o.Attempt = v
}

// GetFaults returns the Faults field value
func (o *EpisodeResult) GetFaults() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Faults
}

// GetFaultsOk returns a tuple with the Faults field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetFaultsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Faults, true
}

// SetFaults sets field value
func (o *EpisodeResult) SetFaults(v int32) {
	o.Faults = v
}

// GetOutcome returns the Outcome field value
func (o *EpisodeResult) GetOutcome() Outcome {
	if o == nil {
		var ret Outcome
		return ret
	}

	return o.Outcome
}

// GetOutcomeOk returns a tuple with the Outcome field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetOutcomeOk() (*Outcome, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Outcome, true
}

// SetOutcome sets field value
func (o *EpisodeResult) SetOutcome(v Outcome) {
	o.Outcome = v
}

// GetScore returns the Score field value
func (o *EpisodeResult) GetScore() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.Score
}

// GetScoreOk returns a tuple with the Score field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetScoreOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Score, true
}

// SetScore sets field value
func (o *EpisodeResult) SetScore(v float64) {
	o.Score = v
}

// GetSteps returns the Steps field value
func (o *EpisodeResult) GetSteps() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Steps
}

// GetStepsOk returns a tuple with the Steps field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetStepsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Steps, true
}

// SetSteps sets field value
func (o *EpisodeResult) SetSteps(v int32) {
	o.Steps = v
}

// GetTerminated returns the Terminated field value
func (o *EpisodeResult) GetTerminated() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Terminated
}

// GetTerminatedOk returns a tuple with the Terminated field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetTerminatedOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Terminated, true
}

// SetTerminated sets field value
func (o *EpisodeResult) SetTerminated(v bool) {
	o.Terminated = v
}

// GetTruncated returns the Truncated field value
func (o *EpisodeResult) GetTruncated() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Truncated
}

// GetTruncatedOk returns a tuple with the Truncated field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetTruncatedOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Truncated, true
}

// SetTruncated sets field value
func (o *EpisodeResult) SetTruncated(v bool) {
	o.Truncated = v
}

// GetThinkS returns the ThinkS field value
func (o *EpisodeResult) GetThinkS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.ThinkS
}

// GetThinkSOk returns a tuple with the ThinkS field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetThinkSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ThinkS, true
}

// SetThinkS sets field value
func (o *EpisodeResult) SetThinkS(v float64) {
	o.ThinkS = v
}

// GetFinishedAt returns the FinishedAt field value
func (o *EpisodeResult) GetFinishedAt() time.Time {
	if o == nil {
		var ret time.Time
		return ret
	}

	return o.FinishedAt
}

// GetFinishedAtOk returns a tuple with the FinishedAt field value
// and a boolean to check if the value has been set.
func (o *EpisodeResult) GetFinishedAtOk() (*time.Time, bool) {
	if o == nil {
		return nil, false
	}
	return &o.FinishedAt, true
}

// SetFinishedAt sets field value
func (o *EpisodeResult) SetFinishedAt(v time.Time) {
	o.FinishedAt = v
}

func (o EpisodeResult) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o EpisodeResult) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["episode_id"] = o.EpisodeId
	toSerialize["index"] = o.Index
	toSerialize["task"] = o.Task
	toSerialize["split"] = o.Split
	toSerialize["seed"] = o.Seed
	toSerialize["attempt"] = o.Attempt
	toSerialize["faults"] = o.Faults
	toSerialize["outcome"] = o.Outcome
	toSerialize["score"] = o.Score
	toSerialize["steps"] = o.Steps
	toSerialize["terminated"] = o.Terminated
	toSerialize["truncated"] = o.Truncated
	toSerialize["think_s"] = o.ThinkS
	toSerialize["finished_at"] = o.FinishedAt

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *EpisodeResult) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"episode_id",
		"index",
		"task",
		"split",
		"seed",
		"attempt",
		"faults",
		"outcome",
		"score",
		"steps",
		"terminated",
		"truncated",
		"think_s",
		"finished_at",
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

	varEpisodeResult := _EpisodeResult{}

	err = json.Unmarshal(data, &varEpisodeResult)

	if err != nil {
		return err
	}

	*o = EpisodeResult(varEpisodeResult)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "episode_id")
		delete(additionalProperties, "index")
		delete(additionalProperties, "task")
		delete(additionalProperties, "split")
		delete(additionalProperties, "seed")
		delete(additionalProperties, "attempt")
		delete(additionalProperties, "faults")
		delete(additionalProperties, "outcome")
		delete(additionalProperties, "score")
		delete(additionalProperties, "steps")
		delete(additionalProperties, "terminated")
		delete(additionalProperties, "truncated")
		delete(additionalProperties, "think_s")
		delete(additionalProperties, "finished_at")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableEpisodeResult struct {
	value *EpisodeResult
	isSet bool
}

func (v NullableEpisodeResult) Get() *EpisodeResult {
	return v.value
}

func (v *NullableEpisodeResult) Set(val *EpisodeResult) {
	v.value = val
	v.isSet = true
}

func (v NullableEpisodeResult) IsSet() bool {
	return v.isSet
}

func (v *NullableEpisodeResult) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableEpisodeResult(val *EpisodeResult) *NullableEpisodeResult {
	return &NullableEpisodeResult{value: val, isSet: true}
}

func (v NullableEpisodeResult) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableEpisodeResult) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
