// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the RunList type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &RunList{}

// RunList struct for RunList
type RunList struct {
	Runs []Run `json:"runs"`
	NextCursor NullableString `json:"next_cursor"`
	AdditionalProperties map[string]interface{}
}

type _RunList RunList

// NewRunList instantiates a new RunList object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewRunList(runs []Run, nextCursor NullableString) *RunList {
	this := RunList{}
	this.Runs = runs
	this.NextCursor = nextCursor
	return &this
}

// NewRunListWithDefaults instantiates a new RunList object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewRunListWithDefaults() *RunList {
	this := RunList{}
	return &this
}

// GetRuns returns the Runs field value
func (o *RunList) GetRuns() []Run {
	if o == nil {
		var ret []Run
		return ret
	}

	return o.Runs
}

// GetRunsOk returns a tuple with the Runs field value
// and a boolean to check if the value has been set.
func (o *RunList) GetRunsOk() ([]Run, bool) {
	if o == nil {
		return nil, false
	}
	return o.Runs, true
}

// SetRuns sets field value
func (o *RunList) SetRuns(v []Run) {
	o.Runs = v
}

// GetNextCursor returns the NextCursor field value
// If the value is explicit nil, the zero value for string will be returned
func (o *RunList) GetNextCursor() string {
	if o == nil || o.NextCursor.Get() == nil {
		var ret string
		return ret
	}

	return *o.NextCursor.Get()
}

// GetNextCursorOk returns a tuple with the NextCursor field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *RunList) GetNextCursorOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return o.NextCursor.Get(), o.NextCursor.IsSet()
}

// SetNextCursor sets field value
func (o *RunList) SetNextCursor(v string) {
	o.NextCursor.Set(&v)
}

func (o RunList) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o RunList) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["runs"] = o.Runs
	toSerialize["next_cursor"] = o.NextCursor.Get()

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *RunList) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"runs",
		"next_cursor",
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

	varRunList := _RunList{}

	err = json.Unmarshal(data, &varRunList)

	if err != nil {
		return err
	}

	*o = RunList(varRunList)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "runs")
		delete(additionalProperties, "next_cursor")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableRunList struct {
	value *RunList
	isSet bool
}

func (v NullableRunList) Get() *RunList {
	return v.value
}

func (v *NullableRunList) Set(val *RunList) {
	v.value = val
	v.isSet = true
}

func (v NullableRunList) IsSet() bool {
	return v.isSet
}

func (v *NullableRunList) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableRunList(val *RunList) *NullableRunList {
	return &NullableRunList{value: val, isSet: true}
}

func (v NullableRunList) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableRunList) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
