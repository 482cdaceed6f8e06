// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ImageSize type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ImageSize{}

// ImageSize struct for ImageSize
type ImageSize struct {
	Width int32 `json:"width"`
	Height int32 `json:"height"`
	AdditionalProperties map[string]interface{}
}

type _ImageSize ImageSize

// NewImageSize instantiates a new ImageSize object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewImageSize(width int32, height int32) *ImageSize {
	this := ImageSize{}
	this.Width = width
	this.Height = height
	return &this
}

// NewImageSizeWithDefaults instantiates a new ImageSize object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewImageSizeWithDefaults() *ImageSize {
	this := ImageSize{}
	return &this
}

// GetWidth returns the Width field value
func (o *ImageSize) GetWidth() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Width
}

// GetWidthOk returns a tuple with the Width field value
// and a boolean to check if the value has been set.
func (o *ImageSize) GetWidthOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Width, true
}

// SetWidth sets field value
func (o *ImageSize) SetWidth(v int32) {
	o.Width = v
}

// GetHeight returns the Height field value
func (o *ImageSize) GetHeight() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Height
}

// GetHeightOk returns a tuple with the Height field value
// and a boolean to check if the value has been set.
func (o *ImageSize) GetHeightOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Height, true
}

// SetHeight sets field value
func (o *ImageSize) SetHeight(v int32) {
	o.Height = v
}

func (o ImageSize) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ImageSize) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["width"] = o.Width
	toSerialize["height"] = o.Height

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ImageSize) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"width",
		"height",
	}

	allProperties := make(map[string]interface{})

	err = json.Unmarshal(data, &allProperties)

	if err != nil {
		return err;
	}

	for _, requiredProperty := range(requiredProperties) {
		if _, exists := allProperties[requiredProperty]; !exists {
			return fmt.Errorf("no value given for required property %v", requiredProperty)
		}
	}

	varImageSize := _ImageSize{}

	err = json.Unmarshal(data, &varImageSize)

	if err != nil {
		return err
	}

	*o = ImageSize(varImageSize)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "width")
		delete(additionalProperties, "height")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableImageSize struct {
	value *ImageSize
	isSet bool
}

func (v NullableImageSize) Get() *ImageSize {
	return v.value
}

func (v *NullableImageSize) Set(val *ImageSize) {
	v.value = val
	v.isSet = true
}

func (v NullableImageSize) IsSet() bool {
	return v.isSet
}

func (v *NullableImageSize) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableImageSize(val *ImageSize) *NullableImageSize {
	return &NullableImageSize{value: val, isSet: true}
}

func (v NullableImageSize) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableImageSize) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
