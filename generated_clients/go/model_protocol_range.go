// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ProtocolRange type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ProtocolRange{}

// ProtocolRange struct for ProtocolRange
type ProtocolRange struct {
	Min string `json:"min" validate:"regexp=^[0-9]+\\.[0-9]+$"`
	Max string `json:"max" validate:"regexp=^[0-9]+\\.[0-9]+$"`
	AdditionalProperties map[string]interface{}
}

type _ProtocolRange ProtocolRange

// NewProtocolRange instantiates a new ProtocolRange object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewProtocolRange(min string, max string) *ProtocolRange {
	this := ProtocolRange{}
	this.Min = min
	this.Max = max
	return &this
}

// NewProtocolRangeWithDefaults instantiates a new ProtocolRange object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewProtocolRangeWithDefaults() *ProtocolRange {
	this := ProtocolRange{}
	return &this
}

// GetMin returns the Min field value
func (o *ProtocolRange) GetMin() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Min
}

// GetMinOk returns a tuple with the Min field value
// and a boolean to check if the value has been set.
func (o *ProtocolRange) GetMinOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Min, true
}

// SetMin sets field value
func (o *ProtocolRange) SetMin(v string) {
	o.Min = v
}

// GetMax returns the Max field value
func (o *ProtocolRange) GetMax() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Max
}

// GetMaxOk returns a tuple with the Max field value
// and a boolean to check if the value has been set.
func (o *ProtocolRange) GetMaxOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Max, true
}

// SetMax sets field value
func (o *ProtocolRange) SetMax(v string) {
	o.Max = v
}

func (o ProtocolRange) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ProtocolRange) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["min"] = o.Min
	toSerialize["max"] = o.Max

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ProtocolRange) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"min",
		"max",
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

	varProtocolRange := _ProtocolRange{}

	err = json.Unmarshal(data, &varProtocolRange)

	if err != nil {
		return err
	}

	*o = ProtocolRange(varProtocolRange)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "min")
		delete(additionalProperties, "max")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableProtocolRange struct {
	value *ProtocolRange
	isSet bool
}

func (v NullableProtocolRange) Get() *ProtocolRange {
	return v.value
}

func (v *NullableProtocolRange) Set(val *ProtocolRange) {
	v.value = val
	v.isSet = true
}

func (v NullableProtocolRange) IsSet() bool {
	return v.isSet
}

func (v *NullableProtocolRange) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableProtocolRange(val *ProtocolRange) *NullableProtocolRange {
	return &NullableProtocolRange{value: val, isSet: true}
}

func (v NullableProtocolRange) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableProtocolRange) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
