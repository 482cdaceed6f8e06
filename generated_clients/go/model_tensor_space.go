// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the TensorSpace type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &TensorSpace{}

// TensorSpace struct for TensorSpace
type TensorSpace struct {
	Dtype string `json:"dtype" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Shape []int32 `json:"shape"`
	Description string `json:"description"`
	Tasks []string `json:"tasks,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _TensorSpace TensorSpace

// NewTensorSpace instantiates a new TensorSpace object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewTensorSpace(dtype string, shape []int32, description string) *TensorSpace {
	this := TensorSpace{}
	this.Dtype = dtype
	this.Shape = shape
	this.Description = description
	return &this
}

// NewTensorSpaceWithDefaults instantiates a new TensorSpace object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewTensorSpaceWithDefaults() *TensorSpace {
	this := TensorSpace{}
	return &this
}

// GetDtype returns the Dtype field value
func (o *TensorSpace) GetDtype() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Dtype
}

// GetDtypeOk returns a tuple with the Dtype field value
// and a boolean to check if the value has been set.
func (o *TensorSpace) GetDtypeOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Dtype, true
}

// SetDtype sets field value
func (o *TensorSpace) SetDtype(v string) {
	o.Dtype = v
}

// GetShape returns the Shape field value
func (o *TensorSpace) GetShape() []int32 {
	if o == nil {
		var ret []int32
		return ret
	}

	return o.Shape
}

// GetShapeOk returns a tuple with the Shape field value
// and a boolean to check if the value has been set.
func (o *TensorSpace) GetShapeOk() ([]int32, bool) {
	if o == nil {
		return nil, false
	}
	return o.Shape, true
}

// SetShape sets field value
func (o *TensorSpace) SetShape(v []int32) {
	o.Shape = v
}

// GetDescription returns the Description field value
func (o *TensorSpace) GetDescription() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Description
}

// GetDescriptionOk returns a tuple with the Description field value
// and a boolean to check if the value has been set.
func (o *TensorSpace) GetDescriptionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Description, true
}

// SetDescription sets field value
func (o *TensorSpace) SetDescription(v string) {
	o.Description = v
}

// GetTasks returns the Tasks field value if set, zero value otherwise.
func (o *TensorSpace) GetTasks() []string {
	if o == nil || IsNil(o.Tasks) {
		var ret []string
		return ret
	}
	return o.Tasks
}

// GetTasksOk returns a tuple with the Tasks field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *TensorSpace) GetTasksOk() ([]string, bool) {
	if o == nil || IsNil(o.Tasks) {
		return nil, false
	}
	return o.Tasks, true
}

// HasTasks returns a boolean if a field has been set.
func (o *TensorSpace) HasTasks() bool {
	if o != nil && !IsNil(o.Tasks) {
		return true
	}

	return false
}

// SetTasks gets a reference to the given []string and assigns it to the Tasks field.
func (o *TensorSpace) SetTasks(v []string) {
	o.Tasks = v
}

func (o TensorSpace) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o TensorSpace) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["dtype"] = o.Dtype
	toSerialize["shape"] = o.Shape
	toSerialize["description"] = o.Description
	if !IsNil(o.Tasks) {
		toSerialize["tasks"] = o.Tasks
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *TensorSpace) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"dtype",
		"shape",
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

	varTensorSpace := _TensorSpace{}

	err = json.Unmarshal(data, &varTensorSpace)

	if err != nil {
		return err
	}

	*o = TensorSpace(varTensorSpace)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "dtype")
		delete(additionalProperties, "shape")
		delete(additionalProperties, "description")
		delete(additionalProperties, "tasks")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableTensorSpace struct {
	value *TensorSpace
	isSet bool
}

func (v NullableTensorSpace) Get() *TensorSpace {
	return v.value
}

func (v *NullableTensorSpace) Set(val *TensorSpace) {
	v.value = val
	v.isSet = true
}

func (v NullableTensorSpace) IsSet() bool {
	return v.isSet
}

func (v *NullableTensorSpace) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableTensorSpace(val *TensorSpace) *NullableTensorSpace {
	return &NullableTensorSpace{value: val, isSet: true}
}

func (v NullableTensorSpace) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableTensorSpace) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
