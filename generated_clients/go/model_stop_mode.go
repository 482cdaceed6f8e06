// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// StopMode `abort` when absent.
type StopMode string

// List of StopMode
const (
	STOPMODE_ABORT StopMode = "abort"
	STOPMODE_DRAIN StopMode = "drain"
	STOPMODE_UNKNOWN_DEFAULT_OPEN_API StopMode = "unknown_default_open_api"
)

// All allowed values of StopMode enum
var AllowedStopModeEnumValues = []StopMode{
	"abort",
	"drain",
	"unknown_default_open_api",
}

func (v *StopMode) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := StopMode(value)
	for _, existing := range AllowedStopModeEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = STOPMODE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewStopModeFromValue returns a pointer to a valid StopMode
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewStopModeFromValue(v string) (*StopMode, error) {
	ev := StopMode(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for StopMode: valid values are %v", v, AllowedStopModeEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v StopMode) IsValid() bool {
	for _, existing := range AllowedStopModeEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to StopMode value
func (v StopMode) Ptr() *StopMode {
	return &v
}

type NullableStopMode struct {
	value *StopMode
	isSet bool
}

func (v NullableStopMode) Get() *StopMode {
	return v.value
}

func (v *NullableStopMode) Set(val *StopMode) {
	v.value = val
	v.isSet = true
}

func (v NullableStopMode) IsSet() bool {
	return v.isSet
}

func (v *NullableStopMode) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableStopMode(val *StopMode) *NullableStopMode {
	return &NullableStopMode{value: val, isSet: true}
}

func (v NullableStopMode) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableStopMode) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
