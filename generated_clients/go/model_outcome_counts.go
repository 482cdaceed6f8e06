// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the OutcomeCounts type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &OutcomeCounts{}

// OutcomeCounts struct for OutcomeCounts
type OutcomeCounts struct {
	Total int32 `json:"total"`
	Success int32 `json:"success"`
	Failure int32 `json:"failure"`
	Abandoned int32 `json:"abandoned"`
	Unscored int32 `json:"unscored"`
	AdditionalProperties map[string]interface{}
}

type _OutcomeCounts OutcomeCounts

// NewOutcomeCounts instantiates a new OutcomeCounts object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewOutcomeCounts(total int32, success int32, failure int32, abandoned int32, unscored int32) *OutcomeCounts {
	this := OutcomeCounts{}
	this.Total = total
	this.Success = success
	this.Failure = failure
	this.Abandoned = abandoned
	this.Unscored = unscored
	return &this
}

// NewOutcomeCountsWithDefaults instantiates a new OutcomeCounts object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewOutcomeCountsWithDefaults() *OutcomeCounts {
	this := OutcomeCounts{}
	return &this
}

// GetTotal returns the Total field value
func (o *OutcomeCounts) GetTotal() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Total
}

// GetTotalOk returns a tuple with the Total field value
// and a boolean to check if the value has been set.
func (o *OutcomeCounts) GetTotalOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Total, true
}

// SetTotal sets field value
func (o *OutcomeCounts) SetTotal(v int32) {
	o.Total = v
}

// GetSuccess returns the Success field value
func (o *OutcomeCounts) GetSuccess() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Success
}

// GetSuccessOk returns a tuple with the Success field value
// and a boolean to check if the value has been set.
func (o *OutcomeCounts) GetSuccessOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Success, true
}

// SetSuccess sets field value
func (o *OutcomeCounts) SetSuccess(v int32) {
	o.Success = v
}

// GetFailure returns the Failure field value
func (o *OutcomeCounts) GetFailure() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Failure
}

// GetFailureOk returns a tuple with the Failure field value
// and a boolean to check if the value has been set.
func (o *OutcomeCounts) GetFailureOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Failure, true
}

// SetFailure sets field value
func (o *OutcomeCounts) SetFailure(v int32) {
	o.Failure = v
}

// GetAbandoned returns the Abandoned field value
func (o *OutcomeCounts) GetAbandoned() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Abandoned
}

// GetAbandonedOk returns a tuple with the Abandoned field value
// and a boolean to check if the value has been set.
func (o *OutcomeCounts) GetAbandonedOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Abandoned, true
}

// SetAbandoned sets field value
func (o *OutcomeCounts) SetAbandoned(v int32) {
	o.Abandoned = v
}

// GetUnscored returns the Unscored field value
func (o *OutcomeCounts) GetUnscored() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Unscored
}

// GetUnscoredOk returns a tuple with the Unscored field value
// and a boolean to check if the value has been set.
func (o *OutcomeCounts) GetUnscoredOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Unscored, true
}

// SetUnscored sets field value
func (o *OutcomeCounts) SetUnscored(v int32) {
	o.Unscored = v
}

func (o OutcomeCounts) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o OutcomeCounts) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["total"] = o.Total
	toSerialize["success"] = o.Success
	toSerialize["failure"] = o.Failure
	toSerialize["abandoned"] = o.Abandoned
	toSerialize["unscored"] = o.Unscored

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *OutcomeCounts) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"total",
		"success",
		"failure",
		"abandoned",
		"unscored",
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

	varOutcomeCounts := _OutcomeCounts{}

	err = json.Unmarshal(data, &varOutcomeCounts)

	if err != nil {
		return err
	}

	*o = OutcomeCounts(varOutcomeCounts)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "total")
		delete(additionalProperties, "success")
		delete(additionalProperties, "failure")
		delete(additionalProperties, "abandoned")
		delete(additionalProperties, "unscored")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableOutcomeCounts struct {
	value *OutcomeCounts
	isSet bool
}

func (v NullableOutcomeCounts) Get() *OutcomeCounts {
	return v.value
}

func (v *NullableOutcomeCounts) Set(val *OutcomeCounts) {
	v.value = val
	v.isSet = true
}

func (v NullableOutcomeCounts) IsSet() bool {
	return v.isSet
}

func (v *NullableOutcomeCounts) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableOutcomeCounts(val *OutcomeCounts) *NullableOutcomeCounts {
	return &NullableOutcomeCounts{value: val, isSet: true}
}

func (v NullableOutcomeCounts) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableOutcomeCounts) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
