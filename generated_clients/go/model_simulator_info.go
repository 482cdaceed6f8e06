// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the SimulatorInfo type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &SimulatorInfo{}

// SimulatorInfo struct for SimulatorInfo
type SimulatorInfo struct {
	Name string `json:"name"`
	Version string `json:"version"`
	// Named rendering quality, where there is one.
	Quality *string `json:"quality,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _SimulatorInfo SimulatorInfo

// NewSimulatorInfo instantiates a new SimulatorInfo object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewSimulatorInfo(name string, version string) *SimulatorInfo {
	this := SimulatorInfo{}
	this.Name = name
	this.Version = version
	return &this
}

// NewSimulatorInfoWithDefaults instantiates a new SimulatorInfo object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewSimulatorInfoWithDefaults() *SimulatorInfo {
	this := SimulatorInfo{}
	return &this
}

// GetName returns the Name field value
func (o *SimulatorInfo) GetName() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Name
}

// GetNameOk returns a tuple with the Name field value
// and a boolean to check if the value has been set.
func (o *SimulatorInfo) GetNameOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Name, true
}

// SetName sets field value
func (o *SimulatorInfo) SetName(v string) {
	o.Name = v
}

// GetVersion returns the Version field value
func (o *SimulatorInfo) GetVersion() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Version
}

// GetVersionOk returns a tuple with the Version field value
// and a boolean to check if the value has been set.
func (o *SimulatorInfo) GetVersionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Version, true
}

// SetVersion sets field value
func (o *SimulatorInfo) SetVersion(v string) {
	o.Version = v
}

// GetQuality returns the Quality field value if set, zero value otherwise.
func (o *SimulatorInfo) GetQuality() string {
	if o == nil || IsNil(o.Quality) {
		var ret string
		return ret
	}
	return *o.Quality
}

// GetQualityOk returns a tuple with the Quality field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *SimulatorInfo) GetQualityOk() (*string, bool) {
	if o == nil || IsNil(o.Quality) {
		return nil, false
	}
	return o.Quality, true
}

// HasQuality returns a boolean if a field has been set.
func (o *SimulatorInfo) HasQuality() bool {
	if o != nil && !IsNil(o.Quality) {
		return true
	}

	return false
}

// SetQuality gets a reference to the given string and assigns it to the Quality field.
func (o *SimulatorInfo) SetQuality(v string) {
	o.Quality = &v
}

func (o SimulatorInfo) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o SimulatorInfo) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["name"] = o.Name
	toSerialize["version"] = o.Version
	if !IsNil(o.Quality) {
		toSerialize["quality"] = o.Quality
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *SimulatorInfo) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"name",
		"version",
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

	varSimulatorInfo := _SimulatorInfo{}

	err = json.Unmarshal(data, &varSimulatorInfo)

	if err != nil {
		return err
	}

	*o = SimulatorInfo(varSimulatorInfo)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "name")
		delete(additionalProperties, "version")
		delete(additionalProperties, "quality")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableSimulatorInfo struct {
	value *SimulatorInfo
	isSet bool
}

func (v NullableSimulatorInfo) Get() *SimulatorInfo {
	return v.value
}

func (v *NullableSimulatorInfo) Set(val *SimulatorInfo) {
	v.value = val
	v.isSet = true
}

func (v NullableSimulatorInfo) IsSet() bool {
	return v.isSet
}

func (v *NullableSimulatorInfo) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableSimulatorInfo(val *SimulatorInfo) *NullableSimulatorInfo {
	return &NullableSimulatorInfo{value: val, isSet: true}
}

func (v NullableSimulatorInfo) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableSimulatorInfo) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
