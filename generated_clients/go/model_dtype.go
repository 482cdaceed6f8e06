// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// Dtype the model 'Dtype'
type Dtype string

// List of Dtype
const (
	DTYPE_BOOL Dtype = "bool"
	DTYPE_INT8 Dtype = "int8"
	DTYPE_INT16 Dtype = "int16"
	DTYPE_INT32 Dtype = "int32"
	DTYPE_INT64 Dtype = "int64"
	DTYPE_UINT8 Dtype = "uint8"
	DTYPE_UINT16 Dtype = "uint16"
	DTYPE_UINT32 Dtype = "uint32"
	DTYPE_UINT64 Dtype = "uint64"
	DTYPE_FLOAT16 Dtype = "float16"
	DTYPE_FLOAT32 Dtype = "float32"
	DTYPE_FLOAT64 Dtype = "float64"
	DTYPE_UNKNOWN_DEFAULT_OPEN_API Dtype = "unknown_default_open_api"
)

// All allowed values of Dtype enum
var AllowedDtypeEnumValues = []Dtype{
	"bool",
	"int8",
	"int16",
	"int32",
	"int64",
	"uint8",
	"uint16",
	"uint32",
	"uint64",
	"float16",
	"float32",
	"float64",
	"unknown_default_open_api",
}

func (v *Dtype) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := Dtype(value)
	for _, existing := range AllowedDtypeEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = DTYPE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewDtypeFromValue returns a pointer to a valid Dtype
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewDtypeFromValue(v string) (*Dtype, error) {
	ev := Dtype(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for Dtype: valid values are %v", v, AllowedDtypeEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v Dtype) IsValid() bool {
	for _, existing := range AllowedDtypeEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to Dtype value
func (v Dtype) Ptr() *Dtype {
	return &v
}

type NullableDtype struct {
	value *Dtype
	isSet bool
}

func (v NullableDtype) Get() *Dtype {
	return v.value
}

func (v *NullableDtype) Set(val *Dtype) {
	v.value = val
	v.isSet = true
}

func (v NullableDtype) IsSet() bool {
	return v.isSet
}

func (v *NullableDtype) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableDtype(val *Dtype) *NullableDtype {
	return &NullableDtype{value: val, isSet: true}
}

func (v NullableDtype) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableDtype) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
