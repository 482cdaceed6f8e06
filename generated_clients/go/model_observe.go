// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// Observe `last` when absent; `all` adds the observation after every executed action.
type Observe string

// List of Observe
const (
	OBSERVE_LAST Observe = "last"
	OBSERVE_ALL Observe = "all"
	OBSERVE_UNKNOWN_DEFAULT_OPEN_API Observe = "unknown_default_open_api"
)

// All allowed values of Observe enum
var AllowedObserveEnumValues = []Observe{
	"last",
	"all",
	"unknown_default_open_api",
}

func (v *Observe) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := Observe(value)
	for _, existing := range AllowedObserveEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = OBSERVE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewObserveFromValue returns a pointer to a valid Observe
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewObserveFromValue(v string) (*Observe, error) {
	ev := Observe(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for Observe: valid values are %v", v, AllowedObserveEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v Observe) IsValid() bool {
	for _, existing := range AllowedObserveEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to Observe value
func (v Observe) Ptr() *Observe {
	return &v
}

type NullableObserve struct {
	value *Observe
	isSet bool
}

func (v NullableObserve) Get() *Observe {
	return v.value
}

func (v *NullableObserve) Set(val *Observe) {
	v.value = val
	v.isSet = true
}

func (v NullableObserve) IsSet() bool {
	return v.isSet
}

func (v *NullableObserve) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableObserve(val *Observe) *NullableObserve {
	return &NullableObserve{value: val, isSet: true}
}

func (v NullableObserve) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableObserve) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
