// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ImageChoice type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ImageChoice{}

// ImageChoice Recorded with the result, because it changes the score.
type ImageChoice struct {
	Codec string `json:"codec" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Width int32 `json:"width"`
	Height int32 `json:"height"`
	AdditionalProperties map[string]interface{}
}

type _ImageChoice ImageChoice

// NewImageChoice instantiates a new ImageChoice object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewImageChoice(codec string, width int32, height int32) *ImageChoice {
	this := ImageChoice{}
	this.Codec = codec
	this.Width = width
	this.Height = height
	return &this
}

// NewImageChoiceWithDefaults instantiates a new ImageChoice object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewImageChoiceWithDefaults() *ImageChoice {
	this := ImageChoice{}
	return &this
}

// GetCodec returns the Codec field value
func (o *ImageChoice) GetCodec() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Codec
}

// GetCodecOk returns a tuple with the Codec field value
// and a boolean to check if the value has been set.
func (o *ImageChoice) GetCodecOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Codec, true
}

// SetCodec sets field value
func (o *ImageChoice) SetCodec(v string) {
	o.Codec = v
}

// GetWidth returns the Width field value
func (o *ImageChoice) GetWidth() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Width
}

// GetWidthOk returns a tuple with the Width field value
// and a boolean to check if the value has been set.
func (o *ImageChoice) GetWidthOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Width, true
}

// SetWidth sets field value
func (o *ImageChoice) SetWidth(v int32) {
	o.Width = v
}

// GetHeight returns the Height field value
func (o *ImageChoice) GetHeight() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Height
}

// GetHeightOk returns a tuple with the Height field value
// and a boolean to check if the value has been set.
func (o *ImageChoice) GetHeightOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Height, true
}

// SetHeight sets field value
func (o *ImageChoice) SetHeight(v int32) {
	o.Height = v
}

func (o ImageChoice) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ImageChoice) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["codec"] = o.Codec
	toSerialize["width"] = o.Width
	toSerialize["height"] = o.Height

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ImageChoice) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"codec",
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

	varImageChoice := _ImageChoice{}

	err = json.Unmarshal(data, &varImageChoice)

	if err != nil {
		return err
	}

	*o = ImageChoice(varImageChoice)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "codec")
		delete(additionalProperties, "width")
		delete(additionalProperties, "height")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableImageChoice struct {
	value *ImageChoice
	isSet bool
}

func (v NullableImageChoice) Get() *ImageChoice {
	return v.value
}

func (v *NullableImageChoice) Set(val *ImageChoice) {
	v.value = val
	v.isSet = true
}

func (v NullableImageChoice) IsSet() bool {
	return v.isSet
}

func (v *NullableImageChoice) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableImageChoice(val *ImageChoice) *NullableImageChoice {
	return &NullableImageChoice{value: val, isSet: true}
}

func (v NullableImageChoice) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableImageChoice) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
