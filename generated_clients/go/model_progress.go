// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Progress type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Progress{}

// Progress struct for Progress
type Progress struct {
	EpisodesTotal int32 `json:"episodes_total"`
	// Abandoned ones included.
	EpisodesScored int32 `json:"episodes_scored"`
	EpisodesInProgress int32 `json:"episodes_in_progress"`
	EpisodesPending int32 `json:"episodes_pending"`
	AdditionalProperties map[string]interface{}
}

type _Progress Progress

// NewProgress instantiates a new Progress object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewProgress(episodesTotal int32, episodesScored int32, episodesInProgress int32, episodesPending int32) *Progress {
	this := Progress{}
	this.EpisodesTotal = episodesTotal
	this.EpisodesScored = episodesScored
	this.EpisodesInProgress = episodesInProgress
	this.EpisodesPending = episodesPending
	return &this
}

// NewProgressWithDefaults instantiates a new Progress object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewProgressWithDefaults() *Progress {
	this := Progress{}
	return &this
}

// GetEpisodesTotal returns the EpisodesTotal field value
func (o *Progress) GetEpisodesTotal() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.EpisodesTotal
}

// GetEpisodesTotalOk returns a tuple with the EpisodesTotal field value
// and a boolean to check if the value has been set.
func (o *Progress) GetEpisodesTotalOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodesTotal, true
}

// SetEpisodesTotal sets field value
func (o *Progress) SetEpisodesTotal(v int32) {
	o.EpisodesTotal = v
}

// GetEpisodesScored returns the EpisodesScored field value
func (o *Progress) GetEpisodesScored() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.EpisodesScored
}

// GetEpisodesScoredOk returns a tuple with the EpisodesScored field value
// and a boolean to check if the value has been set.
func (o *Progress) GetEpisodesScoredOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodesScored, true
}

// SetEpisodesScored sets field value
func (o *Progress) SetEpisodesScored(v int32) {
	o.EpisodesScored = v
}

// GetEpisodesInProgress returns the EpisodesInProgress field value
func (o *Progress) GetEpisodesInProgress() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.EpisodesInProgress
}

// GetEpisodesInProgressOk returns a tuple with the EpisodesInProgress field value
// and a boolean to check if the value has been set.
func (o *Progress) GetEpisodesInProgressOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodesInProgress, true
}

// SetEpisodesInProgress sets field value
func (o *Progress) SetEpisodesInProgress(v int32) {
	o.EpisodesInProgress = v
}

// GetEpisodesPending returns the EpisodesPending field value
func (o *Progress) GetEpisodesPending() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.EpisodesPending
}

// GetEpisodesPendingOk returns a tuple with the EpisodesPending field value
// and a boolean to check if the value has been set.
func (o *Progress) GetEpisodesPendingOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodesPending, true
}

// SetEpisodesPending sets field value
func (o *Progress) SetEpisodesPending(v int32) {
	o.EpisodesPending = v
}

func (o Progress) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Progress) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["episodes_total"] = o.EpisodesTotal
	toSerialize["episodes_scored"] = o.EpisodesScored
	toSerialize["episodes_in_progress"] = o.EpisodesInProgress
	toSerialize["episodes_pending"] = o.EpisodesPending

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Progress) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"episodes_total",
		"episodes_scored",
		"episodes_in_progress",
		"episodes_pending",
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

	varProgress := _Progress{}

	err = json.Unmarshal(data, &varProgress)

	if err != nil {
		return err
	}

	*o = Progress(varProgress)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "episodes_total")
		delete(additionalProperties, "episodes_scored")
		delete(additionalProperties, "episodes_in_progress")
		delete(additionalProperties, "episodes_pending")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableProgress struct {
	value *Progress
	isSet bool
}

func (v NullableProgress) Get() *Progress {
	return v.value
}

func (v *NullableProgress) Set(val *Progress) {
	v.value = val
	v.isSet = true
}

func (v NullableProgress) IsSet() bool {
	return v.isSet
}

func (v *NullableProgress) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableProgress(val *Progress) *NullableProgress {
	return &NullableProgress{value: val, isSet: true}
}

func (v NullableProgress) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableProgress) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
