// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// Rotation the model 'Rotation'
type Rotation string

// List of Rotation
const (
	ROTATION_NONE Rotation = "none"
	ROTATION_QUATERNION_WXYZ Rotation = "quaternion_wxyz"
	ROTATION_QUATERNION_XYZW Rotation = "quaternion_xyzw"
	ROTATION_AXIS_ANGLE Rotation = "axis_angle"
	ROTATION_EULER_XYZ Rotation = "euler_xyz"
	ROTATION_ROT6D_COLUMNS Rotation = "rot6d_columns"
	ROTATION_UNKNOWN_DEFAULT_OPEN_API Rotation = "unknown_default_open_api"
)

// All allowed values of Rotation enum
var AllowedRotationEnumValues = []Rotation{
	"none",
	"quaternion_wxyz",
	"quaternion_xyzw",
	"axis_angle",
	"euler_xyz",
	"rot6d_columns",
	"unknown_default_open_api",
}

func (v *Rotation) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := Rotation(value)
	for _, existing := range AllowedRotationEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = ROTATION_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewRotationFromValue returns a pointer to a valid Rotation
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewRotationFromValue(v string) (*Rotation, error) {
	ev := Rotation(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for Rotation: valid values are %v", v, AllowedRotationEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v Rotation) IsValid() bool {
	for _, existing := range AllowedRotationEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to Rotation value
func (v Rotation) Ptr() *Rotation {
	return &v
}

type NullableRotation struct {
	value *Rotation
	isSet bool
}

func (v NullableRotation) Get() *Rotation {
	return v.value
}

func (v *NullableRotation) Set(val *Rotation) {
	v.value = val
	v.isSet = true
}

func (v NullableRotation) IsSet() bool {
	return v.isSet
}

func (v *NullableRotation) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableRotation(val *Rotation) *NullableRotation {
	return &NullableRotation{value: val, isSet: true}
}

func (v NullableRotation) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableRotation) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
