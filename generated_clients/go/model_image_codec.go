// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// ImageCodec the model 'ImageCodec'
type ImageCodec string

// List of ImageCodec
const (
	IMAGECODEC_RAW ImageCodec = "raw"
	IMAGECODEC_PNG ImageCodec = "png"
	IMAGECODEC_JPEG ImageCodec = "jpeg"
	IMAGECODEC_UNKNOWN_DEFAULT_OPEN_API ImageCodec = "unknown_default_open_api"
)

// All allowed values of ImageCodec enum
var AllowedImageCodecEnumValues = []ImageCodec{
	"raw",
	"png",
	"jpeg",
	"unknown_default_open_api",
}

func (v *ImageCodec) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := ImageCodec(value)
	for _, existing := range AllowedImageCodecEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = IMAGECODEC_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewImageCodecFromValue returns a pointer to a valid ImageCodec
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewImageCodecFromValue(v string) (*ImageCodec, error) {
	ev := ImageCodec(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for ImageCodec: valid values are %v", v, AllowedImageCodecEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v ImageCodec) IsValid() bool {
	for _, existing := range AllowedImageCodecEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to ImageCodec value
func (v ImageCodec) Ptr() *ImageCodec {
	return &v
}

type NullableImageCodec struct {
	value *ImageCodec
	isSet bool
}

func (v NullableImageCodec) Get() *ImageCodec {
	return v.value
}

func (v *NullableImageCodec) Set(val *ImageCodec) {
	v.value = val
	v.isSet = true
}

func (v NullableImageCodec) IsSet() bool {
	return v.isSet
}

func (v *NullableImageCodec) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableImageCodec(val *ImageCodec) *NullableImageCodec {
	return &NullableImageCodec{value: val, isSet: true}
}

func (v NullableImageCodec) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableImageCodec) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
