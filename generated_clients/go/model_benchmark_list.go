// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the BenchmarkList type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &BenchmarkList{}

// BenchmarkList struct for BenchmarkList
type BenchmarkList struct {
	Benchmarks []BenchmarkSummary `json:"benchmarks"`
	AdditionalProperties map[string]interface{}
}

type _BenchmarkList BenchmarkList

// NewBenchmarkList instantiates a new BenchmarkList object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewBenchmarkList(benchmarks []BenchmarkSummary) *BenchmarkList {
	this := BenchmarkList{}
	this.Benchmarks = benchmarks
	return &this
}

// NewBenchmarkListWithDefaults instantiates a new BenchmarkList object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewBenchmarkListWithDefaults() *BenchmarkList {
	this := BenchmarkList{}
	return &this
}

// GetBenchmarks returns the Benchmarks field value
func (o *BenchmarkList) GetBenchmarks() []BenchmarkSummary {
	if o == nil {
		var ret []BenchmarkSummary
		return ret
	}

	return o.Benchmarks
}

// GetBenchmarksOk returns a tuple with the Benchmarks field value
// and a boolean to check if the value has been set.
func (o *BenchmarkList) GetBenchmarksOk() ([]BenchmarkSummary, bool) {
	if o == nil {
		return nil, false
	}
	return o.Benchmarks, true
}

// SetBenchmarks sets field value
func (o *BenchmarkList) SetBenchmarks(v []BenchmarkSummary) {
	o.Benchmarks = v
}

func (o BenchmarkList) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o BenchmarkList) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["benchmarks"] = o.Benchmarks

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *BenchmarkList) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"benchmarks",
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

	varBenchmarkList := _BenchmarkList{}

	err = json.Unmarshal(data, &varBenchmarkList)

	if err != nil {
		return err
	}

	*o = BenchmarkList(varBenchmarkList)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "benchmarks")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableBenchmarkList struct {
	value *BenchmarkList
	isSet bool
}

func (v NullableBenchmarkList) Get() *BenchmarkList {
	return v.value
}

func (v *NullableBenchmarkList) Set(val *BenchmarkList) {
	v.value = val
	v.isSet = true
}

func (v NullableBenchmarkList) IsSet() bool {
	return v.isSet
}

func (v *NullableBenchmarkList) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableBenchmarkList(val *BenchmarkList) *NullableBenchmarkList {
	return &NullableBenchmarkList{value: val, isSet: true}
}

func (v NullableBenchmarkList) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableBenchmarkList) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
