// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the GroupScore type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &GroupScore{}

// GroupScore struct for GroupScore
type GroupScore struct {
	Counts OutcomeCounts `json:"counts"`
	Mean NullableFloat64 `json:"mean"`
	SuccessRate NullableFloat64 `json:"success_rate"`
	AdditionalProperties map[string]interface{}
}

type _GroupScore GroupScore

// NewGroupScore instantiates a new GroupScore object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewGroupScore(counts OutcomeCounts, mean NullableFloat64, successRate NullableFloat64) *GroupScore {
	this := GroupScore{}
	this.Counts = counts
	this.Mean = mean
	this.SuccessRate = successRate
	return &this
}

// NewGroupScoreWithDefaults instantiates a new GroupScore object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewGroupScoreWithDefaults() *GroupScore {
	this := GroupScore{}
	return &this
}

// GetCounts returns the Counts field value
func (o *GroupScore) GetCounts() OutcomeCounts {
	if o == nil {
		var ret OutcomeCounts
		return ret
	}

	return o.Counts
}

// GetCountsOk returns a tuple with the Counts field value
// and a boolean to check if the value has been set.
func (o *GroupScore) GetCountsOk() (*OutcomeCounts, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Counts, true
}

// SetCounts sets field value
func (o *GroupScore) SetCounts(v OutcomeCounts) {
	o.Counts = v
}

// GetMean returns the Mean field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *GroupScore) GetMean() float64 {
	if o == nil || o.Mean.Get() == nil {
		var ret float64
		return ret
	}

	return *o.Mean.Get()
}

// GetMeanOk returns a tuple with the Mean field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *GroupScore) GetMeanOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Mean.Get(), o.Mean.IsSet()
}

// SetMean sets field value
func (o *GroupScore) SetMean(v float64) {
	o.Mean.Set(&v)
}

// GetSuccessRate returns the SuccessRate field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *GroupScore) GetSuccessRate() float64 {
	if o == nil || o.SuccessRate.Get() == nil {
		var ret float64
		return ret
	}

	return *o.SuccessRate.Get()
}

// GetSuccessRateOk returns a tuple with the SuccessRate field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *GroupScore) GetSuccessRateOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.SuccessRate.Get(), o.SuccessRate.IsSet()
}

// SetSuccessRate sets field value
func (o *GroupScore) SetSuccessRate(v float64) {
	o.SuccessRate.Set(&v)
}

func (o GroupScore) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o GroupScore) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["counts"] = o.Counts
	toSerialize["mean"] = o.Mean.Get()
	toSerialize["success_rate"] = o.SuccessRate.Get()

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *GroupScore) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"counts",
		"mean",
		"success_rate",
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

	varGroupScore := _GroupScore{}

	err = json.Unmarshal(data, &varGroupScore)

	if err != nil {
		return err
	}

	*o = GroupScore(varGroupScore)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "counts")
		delete(additionalProperties, "mean")
		delete(additionalProperties, "success_rate")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableGroupScore struct {
	value *GroupScore
	isSet bool
}

func (v NullableGroupScore) Get() *GroupScore {
	return v.value
}

func (v *NullableGroupScore) Set(val *GroupScore) {
	v.value = val
	v.isSet = true
}

func (v NullableGroupScore) IsSet() bool {
	return v.isSet
}

func (v *NullableGroupScore) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableGroupScore(val *GroupScore) *NullableGroupScore {
	return &NullableGroupScore{value: val, isSet: true}
}

func (v NullableGroupScore) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableGroupScore) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
