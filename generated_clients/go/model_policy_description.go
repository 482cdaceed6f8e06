// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the PolicyDescription type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &PolicyDescription{}

// PolicyDescription What a policy server says of itself; see policy.yaml.
type PolicyDescription struct {
	Name string `json:"name"`
	Version *string `json:"version,omitempty"`
	Protocol ProtocolRange `json:"protocol"`
	// Most episodes that it plays at a time.
	MaxSessions int32 `json:"max_sessions"`
	Assumes *Assumptions `json:"assumes,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _PolicyDescription PolicyDescription

// NewPolicyDescription instantiates a new PolicyDescription object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewPolicyDescription(name string, protocol ProtocolRange, maxSessions int32) *PolicyDescription {
	this := PolicyDescription{}
	this.Name = name
	this.Protocol = protocol
	this.MaxSessions = maxSessions
	return &this
}

// NewPolicyDescriptionWithDefaults instantiates a new PolicyDescription object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewPolicyDescriptionWithDefaults() *PolicyDescription {
	this := PolicyDescription{}
	return &this
}

// GetName returns the Name field value
func (o *PolicyDescription) GetName() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Name
}

// GetNameOk returns a tuple with the Name field value
// and a boolean to check if the value has been set.
func (o *PolicyDescription) GetNameOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Name, true
}

// SetName sets field value
func (o *PolicyDescription) SetName(v string) {
	o.Name = v
}

// GetVersion returns the Version field value if set, zero value otherwise.
func (o *PolicyDescription) GetVersion() string {
	if o == nil || IsNil(o.Version) {
		var ret string
		return ret
	}
	return *o.Version
}

// GetVersionOk returns a tuple with the Version field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyDescription) GetVersionOk() (*string, bool) {
	if o == nil || IsNil(o.Version) {
		return nil, false
	}
	return o.Version, true
}

// HasVersion returns a boolean if a field has been set.
func (o *PolicyDescription) HasVersion() bool {
	if o != nil && !IsNil(o.Version) {
		return true
	}

	return false
}

// SetVersion gets a reference to the given string and assigns it to the Version field.
func (o *PolicyDescription) SetVersion(v string) {
	o.Version = &v
}

// GetProtocol returns the Protocol field value
func (o *PolicyDescription) GetProtocol() ProtocolRange {
	if o == nil {
		var ret ProtocolRange
		return ret
	}

	return o.Protocol
}

// GetProtocolOk returns a tuple with the Protocol field value
// and a boolean to check if the value has been set.
func (o *PolicyDescription) GetProtocolOk() (*ProtocolRange, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Protocol, true
}

// SetProtocol sets field value
func (o *PolicyDescription) SetProtocol(v ProtocolRange) {
	o.Protocol = v
}

// GetMaxSessions returns the MaxSessions field value
func (o *PolicyDescription) GetMaxSessions() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxSessions
}

// GetMaxSessionsOk returns a tuple with the MaxSessions field value
// and a boolean to check if the value has been set.
func (o *PolicyDescription) GetMaxSessionsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxSessions, true
}

// SetMaxSessions sets field value
func (o *PolicyDescription) SetMaxSessions(v int32) {
	o.MaxSessions = v
}

// GetAssumes returns the Assumes field value if set, zero value otherwise.
func (o *PolicyDescription) GetAssumes() Assumptions {
	if o == nil || IsNil(o.Assumes) {
		var ret Assumptions
		return ret
	}
	return *o.Assumes
}

// GetAssumesOk returns a tuple with the Assumes field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyDescription) GetAssumesOk() (*Assumptions, bool) {
	if o == nil || IsNil(o.Assumes) {
		return nil, false
	}
	return o.Assumes, true
}

// HasAssumes returns a boolean if a field has been set.
func (o *PolicyDescription) HasAssumes() bool {
	if o != nil && !IsNil(o.Assumes) {
		return true
	}

	return false
}

// SetAssumes gets a reference to the given Assumptions and assigns it to the Assumes field.
func (o *PolicyDescription) SetAssumes(v Assumptions) {
	o.Assumes = &v
}

func (o PolicyDescription) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o PolicyDescription) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["name"] = o.Name
	if !IsNil(o.Version) {
		toSerialize["version"] = o.Version
	}
	toSerialize["protocol"] = o.Protocol
	toSerialize["max_sessions"] = o.MaxSessions
	if !IsNil(o.Assumes) {
		toSerialize["assumes"] = o.Assumes
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *PolicyDescription) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"name",
		"protocol",
		"max_sessions",
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

	varPolicyDescription := _PolicyDescription{}

	err = json.Unmarshal(data, &varPolicyDescription)

	if err != nil {
		return err
	}

	*o = PolicyDescription(varPolicyDescription)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "name")
		delete(additionalProperties, "version")
		delete(additionalProperties, "protocol")
		delete(additionalProperties, "max_sessions")
		delete(additionalProperties, "assumes")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullablePolicyDescription struct {
	value *PolicyDescription
	isSet bool
}

func (v NullablePolicyDescription) Get() *PolicyDescription {
	return v.value
}

func (v *NullablePolicyDescription) Set(val *PolicyDescription) {
	v.value = val
	v.isSet = true
}

func (v NullablePolicyDescription) IsSet() bool {
	return v.isSet
}

func (v *NullablePolicyDescription) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullablePolicyDescription(val *PolicyDescription) *NullablePolicyDescription {
	return &NullablePolicyDescription{value: val, isSet: true}
}

func (v NullablePolicyDescription) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullablePolicyDescription) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
