// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ObservationSpace type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ObservationSpace{}

// ObservationSpace struct for ObservationSpace
type ObservationSpace struct {
	State map[string]VectorSpace `json:"state"`
	Images map[string]ImageSpace `json:"images"`
	Tensors map[string]TensorSpace `json:"tensors"`
	AdditionalProperties map[string]interface{}
}

type _ObservationSpace ObservationSpace

// NewObservationSpace instantiates a new ObservationSpace object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewObservationSpace(state map[string]VectorSpace, images map[string]ImageSpace, tensors map[string]TensorSpace) *ObservationSpace {
	this := ObservationSpace{}
	this.State = state
	this.Images = images
	this.Tensors = tensors
	return &this
}

// NewObservationSpaceWithDefaults instantiates a new ObservationSpace object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewObservationSpaceWithDefaults() *ObservationSpace {
	this := ObservationSpace{}
	return &this
}

// GetState returns the State field value
func (o *ObservationSpace) GetState() map[string]VectorSpace {
	if o == nil {
		var ret map[string]VectorSpace
		return ret
	}

	return o.State
}

// GetStateOk returns a tuple with the State field value
// and a boolean to check if the value has been set.
func (o *ObservationSpace) GetStateOk() (map[string]VectorSpace, bool) {
	if o == nil {
		return map[string]VectorSpace{}, false
	}
	return o.State, true
}

// SetState sets field value
func (o *ObservationSpace) SetState(v map[string]VectorSpace) {
	o.State = v
}

// GetImages returns the Images field value
func (o *ObservationSpace) GetImages() map[string]ImageSpace {
	if o == nil {
		var ret map[string]ImageSpace
		return ret
	}

	return o.Images
}

// GetImagesOk returns a tuple with the Images field value
// and a boolean to check if the value has been set.
func (o *ObservationSpace) GetImagesOk() (map[string]ImageSpace, bool) {
	if o == nil {
		return map[string]ImageSpace{}, false
	}
	return o.Images, true
}

// SetImages sets field value
func (o *ObservationSpace) SetImages(v map[string]ImageSpace) {
	o.Images = v
}

// GetTensors returns the Tensors field value
func (o *ObservationSpace) GetTensors() map[string]TensorSpace {
	if o == nil {
		var ret map[string]TensorSpace
		return ret
	}

	return o.Tensors
}

// GetTensorsOk returns a tuple with the Tensors field value
// and a boolean to check if the value has been set.
func (o *ObservationSpace) GetTensorsOk() (map[string]TensorSpace, bool) {
	if o == nil {
		return map[string]TensorSpace{}, false
	}
	return o.Tensors, true
}

// SetTensors sets field value
func (o *ObservationSpace) SetTensors(v map[string]TensorSpace) {
	o.Tensors = v
}

func (o ObservationSpace) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ObservationSpace) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["state"] = o.State
	toSerialize["images"] = o.Images
	toSerialize["tensors"] = o.Tensors

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ObservationSpace) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"state",
		"images",
		"tensors",
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

	varObservationSpace := _ObservationSpace{}

	err = json.Unmarshal(data, &varObservationSpace)

	if err != nil {
		return err
	}

	*o = ObservationSpace(varObservationSpace)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "state")
		delete(additionalProperties, "images")
		delete(additionalProperties, "tensors")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableObservationSpace struct {
	value *ObservationSpace
	isSet bool
}

func (v NullableObservationSpace) Get() *ObservationSpace {
	return v.value
}

func (v *NullableObservationSpace) Set(val *ObservationSpace) {
	v.value = val
	v.isSet = true
}

func (v NullableObservationSpace) IsSet() bool {
	return v.isSet
}

func (v *NullableObservationSpace) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableObservationSpace(val *ObservationSpace) *NullableObservationSpace {
	return &NullableObservationSpace{value: val, isSet: true}
}

func (v NullableObservationSpace) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableObservationSpace) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
