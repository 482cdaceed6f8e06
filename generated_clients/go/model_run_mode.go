// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// RunMode `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own.
type RunMode string

// List of RunMode
const (
	RUNMODE_PULL RunMode = "pull"
	RUNMODE_PUSH RunMode = "push"
	RUNMODE_UNKNOWN_DEFAULT_OPEN_API RunMode = "unknown_default_open_api"
)

// All allowed values of RunMode enum
var AllowedRunModeEnumValues = []RunMode{
	"pull",
	"push",
	"unknown_default_open_api",
}

func (v *RunMode) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := RunMode(value)
	for _, existing := range AllowedRunModeEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = RUNMODE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewRunModeFromValue returns a pointer to a valid RunMode
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewRunModeFromValue(v string) (*RunMode, error) {
	ev := RunMode(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for RunMode: valid values are %v", v, AllowedRunModeEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v RunMode) IsValid() bool {
	for _, existing := range AllowedRunModeEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to RunMode value
func (v RunMode) Ptr() *RunMode {
	return &v
}

type NullableRunMode struct {
	value *RunMode
	isSet bool
}

func (v NullableRunMode) Get() *RunMode {
	return v.value
}

func (v *NullableRunMode) Set(val *RunMode) {
	v.value = val
	v.isSet = true
}

func (v NullableRunMode) IsSet() bool {
	return v.isSet
}

func (v *NullableRunMode) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableRunMode(val *RunMode) *NullableRunMode {
	return &NullableRunMode{value: val, isSet: true}
}

func (v NullableRunMode) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableRunMode) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
