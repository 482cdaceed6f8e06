// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ImageSpace type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ImageSpace{}

// ImageSpace struct for ImageSpace
type ImageSpace struct {
	Channels int32 `json:"channels"`
	Description string `json:"description"`
	Tasks []string `json:"tasks,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _ImageSpace ImageSpace

// NewImageSpace instantiates a new ImageSpace object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewImageSpace(channels int32, description string) *ImageSpace {
	this := ImageSpace{}
	this.Channels = channels
	this.Description = description
	return &this
}

// NewImageSpaceWithDefaults instantiates a new ImageSpace object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewImageSpaceWithDefaults() *ImageSpace {
	this := ImageSpace{}
	return &this
}

// GetChannels returns the Channels field value
func (o *ImageSpace) GetChannels() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Channels
}

// GetChannelsOk returns a tuple with the Channels field value
// and a boolean to check if the value has been set.
func (o *ImageSpace) GetChannelsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Channels, true
}

// SetChannels sets field value
func (o *ImageSpace) SetChannels(v int32) {
	o.Channels = v
}

// GetDescription returns the Description field value
func (o *ImageSpace) GetDescription() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Description
}

// GetDescriptionOk returns a tuple with the Description field value
// and a boolean to check if the value has been set.
func (o *ImageSpace) GetDescriptionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Description, true
}

// SetDescription sets field value
func (o *ImageSpace) SetDescription(v string) {
	o.Description = v
}

// GetTasks returns the Tasks field value if set, zero value otherwise.
func (o *ImageSpace) GetTasks() []string {
	if o == nil || IsNil(o.Tasks) {
		var ret []string
		return ret
	}
	return o.Tasks
}

// GetTasksOk returns a tuple with the Tasks field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *ImageSpace) GetTasksOk() ([]string, bool) {
	if o == nil || IsNil(o.Tasks) {
		return nil, false
	}
	return o.Tasks, true
}

// HasTasks returns a boolean if a field has been set.
func (o *ImageSpace) HasTasks() bool {
	if o != nil && !IsNil(o.Tasks) {
		return true
	}

	return false
}

// SetTasks gets a reference to the given []string and assigns it to the Tasks field.
func (o *ImageSpace) SetTasks(v []string) {
	o.Tasks = v
}

func (o ImageSpace) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ImageSpace) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["channels"] = o.Channels
	toSerialize["description"] = o.Description
	if !IsNil(o.Tasks) {
		toSerialize["tasks"] = o.Tasks
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ImageSpace) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"channels",
		"description",
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

	varImageSpace := _ImageSpace{}

	err = json.Unmarshal(data, &varImageSpace)

	if err != nil {
		return err
	}

	*o = ImageSpace(varImageSpace)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "channels")
		delete(additionalProperties, "description")
		delete(additionalProperties, "tasks")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableImageSpace struct {
	value *ImageSpace
	isSet bool
}

func (v NullableImageSpace) Get() *ImageSpace {
	return v.value
}

func (v *NullableImageSpace) Set(val *ImageSpace) {
	v.value = val
	v.isSet = true
}

func (v NullableImageSpace) IsSet() bool {
	return v.isSet
}

func (v *NullableImageSpace) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableImageSpace(val *ImageSpace) *NullableImageSpace {
	return &NullableImageSpace{value: val, isSet: true}
}

func (v NullableImageSpace) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableImageSpace) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
