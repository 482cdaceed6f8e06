// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ComparedTask type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ComparedTask{}

// ComparedTask struct for ComparedTask
type ComparedTask struct {
	Paired int32 `json:"paired"`
	BaselineMean NullableFloat64 `json:"baseline_mean"`
	Mean NullableFloat64 `json:"mean"`
	Difference NullableFloat64 `json:"difference"`
	AdditionalProperties map[string]interface{}
}

type _ComparedTask ComparedTask

// NewComparedTask instantiates a new ComparedTask object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewComparedTask(paired int32, baselineMean NullableFloat64, mean NullableFloat64, difference NullableFloat64) *ComparedTask {
	this := ComparedTask{}
	this.Paired = paired
	this.BaselineMean = baselineMean
	this.Mean = mean
	this.Difference = difference
	return &this
}

// NewComparedTaskWithDefaults instantiates a new ComparedTask object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewComparedTaskWithDefaults() *ComparedTask {
	this := ComparedTask{}
	return &this
}

// GetPaired returns the Paired field value
func (o *ComparedTask) GetPaired() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Paired
}

// GetPairedOk returns a tuple with the Paired field value
// and a boolean to check if the value has been set.
func (o *ComparedTask) GetPairedOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Paired, true
}

// SetPaired sets field value
func (o *ComparedTask) SetPaired(v int32) {
	o.Paired = v
}

// GetBaselineMean returns the BaselineMean field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *ComparedTask) GetBaselineMean() float64 {
	if o == nil || o.BaselineMean.Get() == nil {
		var ret float64
		return ret
	}

	return *o.BaselineMean.Get()
}

// GetBaselineMeanOk returns a tuple with the BaselineMean field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *ComparedTask) GetBaselineMeanOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.BaselineMean.Get(), o.BaselineMean.IsSet()
}

// SetBaselineMean sets field value
func (o *ComparedTask) SetBaselineMean(v float64) {
	o.BaselineMean.Set(&v)
}

// GetMean returns the Mean field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *ComparedTask) GetMean() float64 {
	if o == nil || o.Mean.Get() == nil {
		var ret float64
		return ret
	}

	return *o.Mean.Get()
}

// GetMeanOk returns a tuple with the Mean field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *ComparedTask) GetMeanOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Mean.Get(), o.Mean.IsSet()
}

// SetMean sets field value
func (o *ComparedTask) SetMean(v float64) {
	o.Mean.Set(&v)
}

// GetDifference returns the Difference field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *ComparedTask) GetDifference() float64 {
	if o == nil || o.Difference.Get() == nil {
		var ret float64
		return ret
	}

	return *o.Difference.Get()
}

// GetDifferenceOk returns a tuple with the Difference field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *ComparedTask) GetDifferenceOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Difference.Get(), o.Difference.IsSet()
}

// SetDifference sets field value
func (o *ComparedTask) SetDifference(v float64) {
	o.Difference.Set(&v)
}

func (o ComparedTask) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ComparedTask) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["paired"] = o.Paired
	toSerialize["baseline_mean"] = o.BaselineMean.Get()
	toSerialize["mean"] = o.Mean.Get()
	toSerialize["difference"] = o.Difference.Get()

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ComparedTask) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"paired",
		"baseline_mean",
		"mean",
		"difference",
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

	varComparedTask := _ComparedTask{}

	err = json.Unmarshal(data, &varComparedTask)

	if err != nil {
		return err
	}

	*o = ComparedTask(varComparedTask)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "paired")
		delete(additionalProperties, "baseline_mean")
		delete(additionalProperties, "mean")
		delete(additionalProperties, "difference")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableComparedTask struct {
	value *ComparedTask
	isSet bool
}

func (v NullableComparedTask) Get() *ComparedTask {
	return v.value
}

func (v *NullableComparedTask) Set(val *ComparedTask) {
	v.value = val
	v.isSet = true
}

func (v NullableComparedTask) IsSet() bool {
	return v.isSet
}

func (v *NullableComparedTask) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableComparedTask(val *ComparedTask) *NullableComparedTask {
	return &NullableComparedTask{value: val, isSet: true}
}

func (v NullableComparedTask) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableComparedTask) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
