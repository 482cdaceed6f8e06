// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Fault type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Fault{}

// Fault The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed.
type Fault struct {
	EpisodeId string `json:"episode_id"`
	// Faults of this episode so far.
	Faults int32 `json:"faults"`
	Detail string `json:"detail"`
	AdditionalProperties map[string]interface{}
}

type _Fault Fault

// NewFault instantiates a new Fault object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewFault(episodeId string, faults int32, detail string) *Fault {
	this := Fault{}
	this.EpisodeId = episodeId
	this.Faults = faults
	this.Detail = detail
	return &this
}

// NewFaultWithDefaults instantiates a new Fault object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewFaultWithDefaults() *Fault {
	this := Fault{}
	return &this
}

// GetEpisodeId returns the EpisodeId field value
func (o *Fault) GetEpisodeId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.EpisodeId
}

// GetEpisodeIdOk returns a tuple with the EpisodeId field value
// and a boolean to check if the value has been set.
func (o *Fault) GetEpisodeIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodeId, true
}

// SetEpisodeId sets field value
func (o *Fault) SetEpisodeId(v string) {
	o.EpisodeId = v
}

// GetFaults returns the Faults field value
func (o *Fault) GetFaults() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Faults
}

// GetFaultsOk returns a tuple with the Faults field value
// and a boolean to check if the value has been set.
func (o *Fault) GetFaultsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Faults, true
}

// SetFaults sets field value
func (o *Fault) SetFaults(v int32) {
	o.Faults = v
}

// GetDetail returns the Detail field value
func (o *Fault) GetDetail() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Detail
}

// GetDetailOk returns a tuple with the Detail field value
// and a boolean to check if the value has been set.
func (o *Fault) GetDetailOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Detail, true
}

// SetDetail sets field value
func (o *Fault) SetDetail(v string) {
	o.Detail = v
}

func (o Fault) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Fault) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["episode_id"] = o.EpisodeId
	toSerialize["faults"] = o.Faults
	toSerialize["detail"] = o.Detail

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Fault) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"episode_id",
		"faults",
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

	varFault := _Fault{}

	err = json.Unmarshal(data, &varFault)

	if err != nil {
		return err
	}

	*o = Fault(varFault)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "episode_id")
		delete(additionalProperties, "faults")
		delete(additionalProperties, "detail")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableFault struct {
	value *Fault
	isSet bool
}

func (v NullableFault) Get() *Fault {
	return v.value
}

func (v *NullableFault) Set(val *Fault) {
	v.value = val
	v.isSet = true
}

func (v NullableFault) IsSet() bool {
	return v.isSet
}

func (v *NullableFault) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableFault(val *Fault) *NullableFault {
	return &NullableFault{value: val, isSet: true}
}

func (v NullableFault) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableFault) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
