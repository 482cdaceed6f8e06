// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the PolicyInfo type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &PolicyInfo{}

// PolicyInfo struct for PolicyInfo
type PolicyInfo struct {
	Name string `json:"name"`
	Version *string `json:"version,omitempty"`
	Submitter *string `json:"submitter,omitempty"`
	Homepage *string `json:"homepage,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _PolicyInfo PolicyInfo

// NewPolicyInfo instantiates a new PolicyInfo object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewPolicyInfo(name string) *PolicyInfo {
	this := PolicyInfo{}
	this.Name = name
	return &this
}

// NewPolicyInfoWithDefaults instantiates a new PolicyInfo object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewPolicyInfoWithDefaults() *PolicyInfo {
	this := PolicyInfo{}
	return &this
}

// GetName returns the Name field value
func (o *PolicyInfo) GetName() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Name
}

// GetNameOk returns a tuple with the Name field value
// and a boolean to check if the value has been set.
func (o *PolicyInfo) GetNameOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Name, true
}

// SetName sets field value
func (o *PolicyInfo) SetName(v string) {
	o.Name = v
}

// GetVersion returns the Version field value if set, zero value otherwise.
func (o *PolicyInfo) GetVersion() string {
	if o == nil || IsNil(o.Version) {
		var ret string
		return ret
	}
	return *o.Version
}

// GetVersionOk returns a tuple with the Version field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyInfo) GetVersionOk() (*string, bool) {
	if o == nil || IsNil(o.Version) {
		return nil, false
	}
	return o.Version, true
}

// HasVersion returns a boolean if a field has been set.
func (o *PolicyInfo) HasVersion() bool {
	if o != nil && !IsNil(o.Version) {
		return true
	}

	return false
}

// SetVersion gets a reference to the given string and assigns it to the Version field.
func (o *PolicyInfo) SetVersion(v string) {
	o.Version = &v
}

// GetSubmitter returns the Submitter field value if set, zero value otherwise.
func (o *PolicyInfo) GetSubmitter() string {
	if o == nil || IsNil(o.Submitter) {
		var ret string
		return ret
	}
	return *o.Submitter
}

// GetSubmitterOk returns a tuple with the Submitter field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyInfo) GetSubmitterOk() (*string, bool) {
	if o == nil || IsNil(o.Submitter) {
		return nil, false
	}
	return o.Submitter, true
}

// HasSubmitter returns a boolean if a field has been set.
func (o *PolicyInfo) HasSubmitter() bool {
	if o != nil && !IsNil(o.Submitter) {
		return true
	}

	return false
}

// SetSubmitter gets a reference to the given string and assigns it to the Submitter field.
func (o *PolicyInfo) SetSubmitter(v string) {
	o.Submitter = &v
}

// GetHomepage returns the Homepage field value if set, zero value otherwise.
func (o *PolicyInfo) GetHomepage() string {
	if o == nil || IsNil(o.Homepage) {
		var ret string
		return ret
	}
	return *o.Homepage
}

// GetHomepageOk returns a tuple with the Homepage field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyInfo) GetHomepageOk() (*string, bool) {
	if o == nil || IsNil(o.Homepage) {
		return nil, false
	}
	return o.Homepage, true
}

// HasHomepage returns a boolean if a field has been set.
func (o *PolicyInfo) HasHomepage() bool {
	if o != nil && !IsNil(o.Homepage) {
		return true
	}

	return false
}

// SetHomepage gets a reference to the given string and assigns it to the Homepage field.
func (o *PolicyInfo) SetHomepage(v string) {
	o.Homepage = &v
}

func (o PolicyInfo) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o PolicyInfo) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["name"] = o.Name
	if !IsNil(o.Version) {
		toSerialize["version"] = o.Version
	}
	if !IsNil(o.Submitter) {
		toSerialize["submitter"] = o.Submitter
	}
	if !IsNil(o.Homepage) {
		toSerialize["homepage"] = o.Homepage
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *PolicyInfo) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"name",
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

	varPolicyInfo := _PolicyInfo{}

	err = json.Unmarshal(data, &varPolicyInfo)

	if err != nil {
		return err
	}

	*o = PolicyInfo(varPolicyInfo)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "name")
		delete(additionalProperties, "version")
		delete(additionalProperties, "submitter")
		delete(additionalProperties, "homepage")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullablePolicyInfo struct {
	value *PolicyInfo
	isSet bool
}

func (v NullablePolicyInfo) Get() *PolicyInfo {
	return v.value
}

func (v *NullablePolicyInfo) Set(val *PolicyInfo) {
	v.value = val
	v.isSet = true
}

func (v NullablePolicyInfo) IsSet() bool {
	return v.isSet
}

func (v *NullablePolicyInfo) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullablePolicyInfo(val *PolicyInfo) *NullablePolicyInfo {
	return &NullablePolicyInfo{value: val, isSet: true}
}

func (v NullablePolicyInfo) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullablePolicyInfo) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
