// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// OutOfRange the model 'OutOfRange'
type OutOfRange string

// List of OutOfRange
const (
	OUTOFRANGE_REFUSE OutOfRange = "refuse"
	OUTOFRANGE_CLIP OutOfRange = "clip"
	OUTOFRANGE_UNBOUNDED OutOfRange = "unbounded"
	OUTOFRANGE_UNKNOWN_DEFAULT_OPEN_API OutOfRange = "unknown_default_open_api"
)

// All allowed values of OutOfRange enum
var AllowedOutOfRangeEnumValues = []OutOfRange{
	"refuse",
	"clip",
	"unbounded",
	"unknown_default_open_api",
}

func (v *OutOfRange) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := OutOfRange(value)
	for _, existing := range AllowedOutOfRangeEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = OUTOFRANGE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewOutOfRangeFromValue returns a pointer to a valid OutOfRange
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewOutOfRangeFromValue(v string) (*OutOfRange, error) {
	ev := OutOfRange(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for OutOfRange: valid values are %v", v, AllowedOutOfRangeEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v OutOfRange) IsValid() bool {
	for _, existing := range AllowedOutOfRangeEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to OutOfRange value
func (v OutOfRange) Ptr() *OutOfRange {
	return &v
}

type NullableOutOfRange struct {
	value *OutOfRange
	isSet bool
}

func (v NullableOutOfRange) Get() *OutOfRange {
	return v.value
}

func (v *NullableOutOfRange) Set(val *OutOfRange) {
	v.value = val
	v.isSet = true
}

func (v NullableOutOfRange) IsSet() bool {
	return v.isSet
}

func (v *NullableOutOfRange) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableOutOfRange(val *OutOfRange) *NullableOutOfRange {
	return &NullableOutOfRange{value: val, isSet: true}
}

func (v NullableOutOfRange) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableOutOfRange) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
