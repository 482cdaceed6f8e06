// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Interval type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Interval{}

// Interval 95 % interval.
type Interval struct {
	Low float64 `json:"low"`
	High float64 `json:"high"`
	AdditionalProperties map[string]interface{}
}

type _Interval Interval

// NewInterval instantiates a new Interval object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewInterval(low float64, high float64) *Interval {
	this := Interval{}
	this.Low = low
	this.High = high
	return &this
}

// NewIntervalWithDefaults instantiates a new Interval object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewIntervalWithDefaults() *Interval {
	this := Interval{}
	return &this
}

// GetLow returns the Low field value
func (o *Interval) GetLow() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.Low
}

// GetLowOk returns a tuple with the Low field value
// and a boolean to check if the value has been set.
func (o *Interval) GetLowOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Low, true
}

// SetLow sets field value
func (o *Interval) SetLow(v float64) {
	o.Low = v
}

// GetHigh returns the High field value
func (o *Interval) GetHigh() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.High
}

// GetHighOk returns a tuple with the High field value
// and a boolean to check if the value has been set.
func (o *Interval) GetHighOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.High, true
}

// SetHigh sets field value
func (o *Interval) SetHigh(v float64) {
	o.High = v
}

func (o Interval) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Interval) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["low"] = o.Low
	toSerialize["high"] = o.High

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Interval) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"low",
		"high",
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

	varInterval := _Interval{}

	err = json.Unmarshal(data, &varInterval)

	if err != nil {
		return err
	}

	*o = Interval(varInterval)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "low")
		delete(additionalProperties, "high")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableInterval struct {
	value *Interval
	isSet bool
}

func (v NullableInterval) Get() *Interval {
	return v.value
}

func (v *NullableInterval) Set(val *Interval) {
	v.value = val
	v.isSet = true
}

func (v NullableInterval) IsSet() bool {
	return v.isSet
}

func (v *NullableInterval) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableInterval(val *Interval) *NullableInterval {
	return &NullableInterval{value: val, isSet: true}
}

func (v NullableInterval) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableInterval) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
