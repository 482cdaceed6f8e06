// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// SideEffects the model 'SideEffects'
type SideEffects string

// List of SideEffects
const (
	SIDEEFFECTS_NONE SideEffects = "none"
	SIDEEFFECTS_POSSIBLE SideEffects = "possible"
	SIDEEFFECTS_UNKNOWN_DEFAULT_OPEN_API SideEffects = "unknown_default_open_api"
)

// All allowed values of SideEffects enum
var AllowedSideEffectsEnumValues = []SideEffects{
	"none",
	"possible",
	"unknown_default_open_api",
}

func (v *SideEffects) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := SideEffects(value)
	for _, existing := range AllowedSideEffectsEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = SIDEEFFECTS_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewSideEffectsFromValue returns a pointer to a valid SideEffects
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewSideEffectsFromValue(v string) (*SideEffects, error) {
	ev := SideEffects(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for SideEffects: valid values are %v", v, AllowedSideEffectsEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v SideEffects) IsValid() bool {
	for _, existing := range AllowedSideEffectsEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to SideEffects value
func (v SideEffects) Ptr() *SideEffects {
	return &v
}

type NullableSideEffects struct {
	value *SideEffects
	isSet bool
}

func (v NullableSideEffects) Get() *SideEffects {
	return v.value
}

func (v *NullableSideEffects) Set(val *SideEffects) {
	v.value = val
	v.isSet = true
}

func (v NullableSideEffects) IsSet() bool {
	return v.isSet
}

func (v *NullableSideEffects) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableSideEffects(val *SideEffects) *NullableSideEffects {
	return &NullableSideEffects{value: val, isSet: true}
}

func (v NullableSideEffects) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableSideEffects) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
