// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the PolicyServerView type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &PolicyServerView{}

// PolicyServerView The policy server of a run with mode `push`, with what was left open filled in, and without its key.
type PolicyServerView struct {
	Url string `json:"url"`
	// A `PolicyProtocol`, or one of a later version.
	Protocol string `json:"protocol" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	HasApiKey bool `json:"has_api_key"`
	Model *string `json:"model,omitempty"`
	CallTimeoutS float64 `json:"call_timeout_s"`
	MaxConcurrent int32 `json:"max_concurrent"`
	MaxRetries int32 `json:"max_retries"`
	Generation map[string]float64 `json:"generation,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _PolicyServerView PolicyServerView

// NewPolicyServerView instantiates a new PolicyServerView object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewPolicyServerView(url string, protocol string, hasApiKey bool, callTimeoutS float64, maxConcurrent int32, maxRetries int32) *PolicyServerView {
	this := PolicyServerView{}
	this.Url = url
	this.Protocol = protocol
	this.HasApiKey = hasApiKey
	this.CallTimeoutS = callTimeoutS
	this.MaxConcurrent = maxConcurrent
	this.MaxRetries = maxRetries
	return &this
}

// NewPolicyServerViewWithDefaults instantiates a new PolicyServerView object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewPolicyServerViewWithDefaults() *PolicyServerView {
	this := PolicyServerView{}
	return &this
}

// GetUrl returns the Url field value
func (o *PolicyServerView) GetUrl() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Url
}

// GetUrlOk returns a tuple with the Url field value
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetUrlOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Url, true
}

// SetUrl sets field value
func (o *PolicyServerView) SetUrl(v string) {
	o.Url = v
}

// GetProtocol returns the Protocol field value
func (o *PolicyServerView) GetProtocol() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Protocol
}

// GetProtocolOk returns a tuple with the Protocol field value
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetProtocolOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Protocol, true
}

// SetProtocol sets field value
func (o *PolicyServerView) SetProtocol(v string) {
	o.Protocol = v
}

// GetHasApiKey returns the HasApiKey field value
func (o *PolicyServerView) GetHasApiKey() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.HasApiKey
}

// GetHasApiKeyOk returns a tuple with the HasApiKey field value
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetHasApiKeyOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.HasApiKey, true
}

// SetHasApiKey sets field value
func (o *PolicyServerView) SetHasApiKey(v bool) {
	o.HasApiKey = v
}

// GetModel returns the Model field value if set, zero value otherwise.
func (o *PolicyServerView) GetModel() string {
	if o == nil || IsNil(o.Model) {
		var ret string
		return ret
	}
	return *o.Model
}

// GetModelOk returns a tuple with the Model field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetModelOk() (*string, bool) {
	if o == nil || IsNil(o.Model) {
		return nil, false
	}
	return o.Model, true
}

// HasModel returns a boolean if a field has been set.
func (o *PolicyServerView) HasModel() bool {
	if o != nil && !IsNil(o.Model) {
		return true
	}

	return false
}

// SetModel gets a reference to the given string and assigns it to the Model field.
func (o *PolicyServerView) SetModel(v string) {
	o.Model = &v
}

// GetCallTimeoutS returns the CallTimeoutS field value
func (o *PolicyServerView) GetCallTimeoutS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.CallTimeoutS
}

// GetCallTimeoutSOk returns a tuple with the CallTimeoutS field value
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetCallTimeoutSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.CallTimeoutS, true
}

// SetCallTimeoutS sets field value
func (o *PolicyServerView) SetCallTimeoutS(v float64) {
	o.CallTimeoutS = v
}

// GetMaxConcurrent returns the MaxConcurrent field value
func (o *PolicyServerView) GetMaxConcurrent() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxConcurrent
}

// GetMaxConcurrentOk returns a tuple with the MaxConcurrent field value
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetMaxConcurrentOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxConcurrent, true
}

// SetMaxConcurrent sets field value
func (o *PolicyServerView) SetMaxConcurrent(v int32) {
	o.MaxConcurrent = v
}

// GetMaxRetries returns the MaxRetries field value
func (o *PolicyServerView) GetMaxRetries() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxRetries
}

// GetMaxRetriesOk returns a tuple with the MaxRetries field value
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetMaxRetriesOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxRetries, true
}

// SetMaxRetries sets field value
func (o *PolicyServerView) SetMaxRetries(v int32) {
	o.MaxRetries = v
}

// GetGeneration returns the Generation field value if set, zero value otherwise.
func (o *PolicyServerView) GetGeneration() map[string]float64 {
	if o == nil || IsNil(o.Generation) {
		var ret map[string]float64
		return ret
	}
	return o.Generation
}

// GetGenerationOk returns a tuple with the Generation field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServerView) GetGenerationOk() (map[string]float64, bool) {
	if o == nil || IsNil(o.Generation) {
		return map[string]float64{}, false
	}
	return o.Generation, true
}

// HasGeneration returns a boolean if a field has been set.
func (o *PolicyServerView) HasGeneration() bool {
	if o != nil && !IsNil(o.Generation) {
		return true
	}

	return false
}

// SetGeneration gets a reference to the given map[string]float64 and assigns it to the Generation field.
func (o *PolicyServerView) SetGeneration(v map[string]float64) {
	o.Generation = v
}

func (o PolicyServerView) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o PolicyServerView) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["url"] = o.Url
	toSerialize["protocol"] = o.Protocol
	toSerialize["has_api_key"] = o.HasApiKey
	if !IsNil(o.Model) {
		toSerialize["model"] = o.Model
	}
	toSerialize["call_timeout_s"] = o.CallTimeoutS
	toSerialize["max_concurrent"] = o.MaxConcurrent
	toSerialize["max_retries"] = o.MaxRetries
	if !IsNil(o.Generation) {
		toSerialize["generation"] = o.Generation
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *PolicyServerView) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"url",
		"protocol",
		"has_api_key",
		"call_timeout_s",
		"max_concurrent",
		"max_retries",
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

	varPolicyServerView := _PolicyServerView{}

	err = json.Unmarshal(data, &varPolicyServerView)

	if err != nil {
		return err
	}

	*o = PolicyServerView(varPolicyServerView)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "url")
		delete(additionalProperties, "protocol")
		delete(additionalProperties, "has_api_key")
		delete(additionalProperties, "model")
		delete(additionalProperties, "call_timeout_s")
		delete(additionalProperties, "max_concurrent")
		delete(additionalProperties, "max_retries")
		delete(additionalProperties, "generation")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullablePolicyServerView struct {
	value *PolicyServerView
	isSet bool
}

func (v NullablePolicyServerView) Get() *PolicyServerView {
	return v.value
}

func (v *NullablePolicyServerView) Set(val *PolicyServerView) {
	v.value = val
	v.isSet = true
}

func (v NullablePolicyServerView) IsSet() bool {
	return v.isSet
}

func (v *NullablePolicyServerView) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullablePolicyServerView(val *PolicyServerView) *NullablePolicyServerView {
	return &NullablePolicyServerView{value: val, isSet: true}
}

func (v NullablePolicyServerView) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullablePolicyServerView) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
