// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
)

// checks if the StopRun type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &StopRun{}

// StopRun struct for StopRun
type StopRun struct {
	Mode *StopMode `json:"mode,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _StopRun StopRun

// NewStopRun instantiates a new StopRun object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewStopRun() *StopRun {
	this := StopRun{}
	return &this
}

// NewStopRunWithDefaults instantiates a new StopRun object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewStopRunWithDefaults() *StopRun {
	this := StopRun{}
	return &this
}

// GetMode returns the Mode field value if set, zero value otherwise.
func (o *StopRun) GetMode() StopMode {
	if o == nil || IsNil(o.Mode) {
		var ret StopMode
		return ret
	}
	return *o.Mode
}

// GetModeOk returns a tuple with the Mode field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *StopRun) GetModeOk() (*StopMode, bool) {
	if o == nil || IsNil(o.Mode) {
		return nil, false
	}
	return o.Mode, true
}

// HasMode returns a boolean if a field has been set.
func (o *StopRun) HasMode() bool {
	if o != nil && !IsNil(o.Mode) {
		return true
	}

	return false
}

// SetMode gets a reference to the given StopMode and assigns it to the Mode field.
func (o *StopRun) SetMode(v StopMode) {
	o.Mode = &v
}

func (o StopRun) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o StopRun) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	if !IsNil(o.Mode) {
		toSerialize["mode"] = o.Mode
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *StopRun) UnmarshalJSON(data []byte) (err error) {
	varStopRun := _StopRun{}

	err = json.Unmarshal(data, &varStopRun)

	if err != nil {
		return err
	}

	*o = StopRun(varStopRun)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "mode")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableStopRun struct {
	value *StopRun
	isSet bool
}

func (v NullableStopRun) Get() *StopRun {
	return v.value
}

func (v *NullableStopRun) Set(val *StopRun) {
	v.value = val
	v.isSet = true
}

func (v NullableStopRun) IsSet() bool {
	return v.isSet
}

func (v *NullableStopRun) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableStopRun(val *StopRun) *NullableStopRun {
	return &NullableStopRun{value: val, isSet: true}
}

func (v NullableStopRun) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableStopRun) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
