// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// RunState the model 'RunState'
type RunState string

// List of RunState
const (
	RUNSTATE_QUEUED RunState = "queued"
	RUNSTATE_READY RunState = "ready"
	RUNSTATE_RUNNING RunState = "running"
	RUNSTATE_STOPPING RunState = "stopping"
	RUNSTATE_STOPPED RunState = "stopped"
	RUNSTATE_FAILED RunState = "failed"
	RUNSTATE_COMPLETED RunState = "completed"
	RUNSTATE_UNKNOWN_DEFAULT_OPEN_API RunState = "unknown_default_open_api"
)

// All allowed values of RunState enum
var AllowedRunStateEnumValues = []RunState{
	"queued",
	"ready",
	"running",
	"stopping",
	"stopped",
	"failed",
	"completed",
	"unknown_default_open_api",
}

func (v *RunState) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := RunState(value)
	for _, existing := range AllowedRunStateEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = RUNSTATE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewRunStateFromValue returns a pointer to a valid RunState
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewRunStateFromValue(v string) (*RunState, error) {
	ev := RunState(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for RunState: valid values are %v", v, AllowedRunStateEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v RunState) IsValid() bool {
	for _, existing := range AllowedRunStateEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to RunState value
func (v RunState) Ptr() *RunState {
	return &v
}

type NullableRunState struct {
	value *RunState
	isSet bool
}

func (v NullableRunState) Get() *RunState {
	return v.value
}

func (v *NullableRunState) Set(val *RunState) {
	v.value = val
	v.isSet = true
}

func (v NullableRunState) IsSet() bool {
	return v.isSet
}

func (v *NullableRunState) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableRunState(val *RunState) *NullableRunState {
	return &NullableRunState{value: val, isSet: true}
}

func (v NullableRunState) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableRunState) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
