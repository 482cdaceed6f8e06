// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Observation type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Observation{}

// Observation struct for Observation
type Observation struct {
	State map[string][]float64 `json:"state"`
	Images map[string]Image `json:"images"`
	Tensors map[string]Tensor `json:"tensors"`
	AdditionalProperties map[string]interface{}
}

type _Observation Observation

// NewObservation instantiates a new Observation object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewObservation(state map[string][]float64, images map[string]Image, tensors map[string]Tensor) *Observation {
	this := Observation{}
	this.State = state
	this.Images = images
	this.Tensors = tensors
	return &this
}

// NewObservationWithDefaults instantiates a new Observation object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewObservationWithDefaults() *Observation {
	this := Observation{}
	return &this
}

// GetState returns the State field value
func (o *Observation) GetState() map[string][]float64 {
	if o == nil {
		var ret map[string][]float64
		return ret
	}

	return o.State
}

// GetStateOk returns a tuple with the State field value
// and a boolean to check if the value has been set.
func (o *Observation) GetStateOk() (map[string][]float64, bool) {
	if o == nil {
		return map[string][]float64{}, false
	}
	return o.State, true
}

// SetState sets field value
func (o *Observation) SetState(v map[string][]float64) {
	o.State = v
}

// GetImages returns the Images field value
func (o *Observation) GetImages() map[string]Image {
	if o == nil {
		var ret map[string]Image
		return ret
	}

	return o.Images
}

// GetImagesOk returns a tuple with the Images field value
// and a boolean to check if the value has been set.
func (o *Observation) GetImagesOk() (map[string]Image, bool) {
	if o == nil {
		return map[string]Image{}, false
	}
	return o.Images, true
}

// SetImages sets field value
func (o *Observation) SetImages(v map[string]Image) {
	o.Images = v
}

// GetTensors returns the Tensors field value
func (o *Observation) GetTensors() map[string]Tensor {
	if o == nil {
		var ret map[string]Tensor
		return ret
	}

	return o.Tensors
}

// GetTensorsOk returns a tuple with the Tensors field value
// and a boolean to check if the value has been set.
func (o *Observation) GetTensorsOk() (map[string]Tensor, bool) {
	if o == nil {
		return map[string]Tensor{}, false
	}
	return o.Tensors, true
}

// SetTensors sets field value
func (o *Observation) SetTensors(v map[string]Tensor) {
	o.Tensors = v
}

func (o Observation) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Observation) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["state"] = o.State
	toSerialize["images"] = o.Images
	toSerialize["tensors"] = o.Tensors

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Observation) UnmarshalJSON(data []byte) (err error) {
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

	varObservation := _Observation{}

	err = json.Unmarshal(data, &varObservation)

	if err != nil {
		return err
	}

	*o = Observation(varObservation)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "state")
		delete(additionalProperties, "images")
		delete(additionalProperties, "tensors")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableObservation struct {
	value *Observation
	isSet bool
}

func (v NullableObservation) Get() *Observation {
	return v.value
}

func (v *NullableObservation) Set(val *Observation) {
	v.value = val
	v.isSet = true
}

func (v NullableObservation) IsSet() bool {
	return v.isSet
}

func (v *NullableObservation) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableObservation(val *Observation) *NullableObservation {
	return &NullableObservation{value: val, isSet: true}
}

func (v NullableObservation) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableObservation) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
