// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ProblemItem type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ProblemItem{}

// ProblemItem struct for ProblemItem
type ProblemItem struct {
	// JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`.
	Pointer string `json:"pointer"`
	Detail string `json:"detail"`
	AdditionalProperties map[string]interface{}
}

type _ProblemItem ProblemItem

// NewProblemItem instantiates a new ProblemItem object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewProblemItem(pointer string, detail string) *ProblemItem {
	this := ProblemItem{}
	this.Pointer = pointer
	this.Detail = detail
	return &this
}

// NewProblemItemWithDefaults instantiates a new ProblemItem object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewProblemItemWithDefaults() *ProblemItem {
	this := ProblemItem{}
	return &this
}

// GetPointer returns the Pointer field value
func (o *ProblemItem) GetPointer() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Pointer
}

// GetPointerOk returns a tuple with the Pointer field value
// and a boolean to check if the value has been set.
func (o *ProblemItem) GetPointerOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Pointer, true
}

// SetPointer sets field value
func (o *ProblemItem) SetPointer(v string) {
	o.Pointer = v
}

// GetDetail returns the Detail field value
func (o *ProblemItem) GetDetail() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Detail
}

// GetDetailOk returns a tuple with the Detail field value
// and a boolean to check if the value has been set.
func (o *ProblemItem) GetDetailOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Detail, true
}

// SetDetail sets field value
func (o *ProblemItem) SetDetail(v string) {
	o.Detail = v
}

func (o ProblemItem) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ProblemItem) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["pointer"] = o.Pointer
	toSerialize["detail"] = o.Detail

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ProblemItem) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"pointer",
		"detail",
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

	varProblemItem := _ProblemItem{}

	err = json.Unmarshal(data, &varProblemItem)

	if err != nil {
		return err
	}

	*o = ProblemItem(varProblemItem)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "pointer")
		delete(additionalProperties, "detail")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableProblemItem struct {
	value *ProblemItem
	isSet bool
}

func (v NullableProblemItem) Get() *ProblemItem {
	return v.value
}

func (v *NullableProblemItem) Set(val *ProblemItem) {
	v.value = val
	v.isSet = true
}

func (v NullableProblemItem) IsSet() bool {
	return v.isSet
}

func (v *NullableProblemItem) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableProblemItem(val *ProblemItem) *NullableProblemItem {
	return &NullableProblemItem{value: val, isSet: true}
}

func (v NullableProblemItem) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableProblemItem) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
