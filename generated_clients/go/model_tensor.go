// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Tensor type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Tensor{}

// Tensor C order, little-endian; a bool is one byte, 0 or 1.
type Tensor struct {
	Dtype string `json:"dtype" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Shape []int64 `json:"shape"`
	// Base64 with padding in JSON; `bin` in MessagePack.
	Data string `json:"data"`
	AdditionalProperties map[string]interface{}
}

type _Tensor Tensor

// NewTensor instantiates a new Tensor object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewTensor(dtype string, shape []int64, data string) *Tensor {
	this := Tensor{}
	this.Dtype = dtype
	this.Shape = shape
	this.Data = data
	return &this
}

// NewTensorWithDefaults instantiates a new Tensor object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewTensorWithDefaults() *Tensor {
	this := Tensor{}
	return &this
}

// GetDtype returns the Dtype field value
func (o *Tensor) GetDtype() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Dtype
}

// GetDtypeOk returns a tuple with the Dtype field value
// and a boolean to check if the value has been set.
func (o *Tensor) GetDtypeOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Dtype, true
}

// SetDtype sets field value
func (o *Tensor) SetDtype(v string) {
	o.Dtype = v
}

// GetShape returns the Shape field value
func (o *Tensor) GetShape() []int64 {
	if o == nil {
		var ret []int64
		return ret
	}

	return o.Shape
}

// GetShapeOk returns a tuple with the Shape field value
// and a boolean to check if the value has been set.
func (o *Tensor) GetShapeOk() ([]int64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Shape, true
}

// SetShape sets field value
func (o *Tensor) SetShape(v []int64) {
	o.Shape = v
}

// GetData returns the Data field value
func (o *Tensor) GetData() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Data
}

// GetDataOk returns a tuple with the Data field value
// and a boolean to check if the value has been set.
func (o *Tensor) GetDataOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Data, true
}

// SetData sets field value
func (o *Tensor) SetData(v string) {
	o.Data = v
}

func (o Tensor) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Tensor) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["dtype"] = o.Dtype
	toSerialize["shape"] = o.Shape
	toSerialize["data"] = o.Data

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Tensor) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"dtype",
		"shape",
		"data",
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

	varTensor := _Tensor{}

	err = json.Unmarshal(data, &varTensor)

	if err != nil {
		return err
	}

	*o = Tensor(varTensor)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "dtype")
		delete(additionalProperties, "shape")
		delete(additionalProperties, "data")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableTensor struct {
	value *Tensor
	isSet bool
}

func (v NullableTensor) Get() *Tensor {
	return v.value
}

func (v *NullableTensor) Set(val *Tensor) {
	v.value = val
	v.isSet = true
}

func (v NullableTensor) IsSet() bool {
	return v.isSet
}

func (v *NullableTensor) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableTensor(val *Tensor) *NullableTensor {
	return &NullableTensor{value: val, isSet: true}
}

func (v NullableTensor) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableTensor) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
