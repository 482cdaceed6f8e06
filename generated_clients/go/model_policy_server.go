// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the PolicyServer type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &PolicyServer{}

// PolicyServer Where the server finds the policy of a run with mode `push`, and how it calls it.
type PolicyServer struct {
	// Base URL, without user, query or fragment; the path of an operation is appended to it.
	Url string `json:"url" validate:"regexp=^https?://[A-Za-z0-9.:_\\[\\]-]+(/[A-Za-z0-9._~%/-]*)?$"`
	Protocol PolicyProtocol `json:"protocol"`
	// Sent as bearer token with every call, and shown to nobody.
	ApiKey *string `json:"api_key,omitempty" validate:"regexp=^[!-~]+$"`
	// Which model is asked, where a protocol knows several.
	Model *string `json:"model,omitempty"`
	// Time for one call, from connecting to the last byte of its answer; 30 when absent.
	CallTimeoutS *float64 `json:"call_timeout_s,omitempty"`
	// Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
	MaxConcurrent *int32 `json:"max_concurrent,omitempty"`
	// How often a call that was not answered is repeated; 3 when absent.
	MaxRetries *int32 `json:"max_retries,omitempty"`
	// Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` alone.
	Generation map[string]float64 `json:"generation,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _PolicyServer PolicyServer

// NewPolicyServer instantiates a new PolicyServer object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewPolicyServer(url string, protocol PolicyProtocol) *PolicyServer {
	this := PolicyServer{}
	this.Url = url
	this.Protocol = protocol
	return &this
}

// NewPolicyServerWithDefaults instantiates a new PolicyServer object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewPolicyServerWithDefaults() *PolicyServer {
	this := PolicyServer{}
	return &this
}

// GetUrl returns the Url field value
func (o *PolicyServer) GetUrl() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Url
}

// GetUrlOk returns a tuple with the Url field value
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetUrlOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Url, true
}

// SetUrl sets field value
func (o *PolicyServer) SetUrl(v string) {
	o.Url = v
}

// GetProtocol returns the Protocol field value
func (o *PolicyServer) GetProtocol() PolicyProtocol {
	if o == nil {
		var ret PolicyProtocol
		return ret
	}

	return o.Protocol
}

// GetProtocolOk returns a tuple with the Protocol field value
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetProtocolOk() (*PolicyProtocol, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Protocol, true
}

// SetProtocol sets field value
func (o *PolicyServer) SetProtocol(v PolicyProtocol) {
	o.Protocol = v
}

// GetApiKey returns the ApiKey field value if set, zero value otherwise.
func (o *PolicyServer) GetApiKey() string {
	if o == nil || IsNil(o.ApiKey) {
		var ret string
		return ret
	}
	return *o.ApiKey
}

// GetApiKeyOk returns a tuple with the ApiKey field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetApiKeyOk() (*string, bool) {
	if o == nil || IsNil(o.ApiKey) {
		return nil, false
	}
	return o.ApiKey, true
}

// HasApiKey returns a boolean if a field has been set.
func (o *PolicyServer) HasApiKey() bool {
	if o != nil && !IsNil(o.ApiKey) {
		return true
	}

	return false
}

// SetApiKey gets a reference to the given string and assigns it to the ApiKey field.
func (o *PolicyServer) SetApiKey(v string) {
	o.ApiKey = &v
}

// GetModel returns the Model field value if set, zero value otherwise.
func (o *PolicyServer) GetModel() string {
	if o == nil || IsNil(o.Model) {
		var ret string
		return ret
	}
	return *o.Model
}

// GetModelOk returns a tuple with the Model field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetModelOk() (*string, bool) {
	if o == nil || IsNil(o.Model) {
		return nil, false
	}
	return o.Model, true
}

// HasModel returns a boolean if a field has been set.
func (o *PolicyServer) HasModel() bool {
	if o != nil && !IsNil(o.Model) {
		return true
	}

	return false
}

// SetModel gets a reference to the given string and assigns it to the Model field.
func (o *PolicyServer) SetModel(v string) {
	o.Model = &v
}

// GetCallTimeoutS returns the CallTimeoutS field value if set, zero value otherwise.
func (o *PolicyServer) GetCallTimeoutS() float64 {
	if o == nil || IsNil(o.CallTimeoutS) {
		var ret float64
		return ret
	}
	return *o.CallTimeoutS
}

// GetCallTimeoutSOk returns a tuple with the CallTimeoutS field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetCallTimeoutSOk() (*float64, bool) {
	if o == nil || IsNil(o.CallTimeoutS) {
		return nil, false
	}
	return o.CallTimeoutS, true
}

// HasCallTimeoutS returns a boolean if a field has been set.
func (o *PolicyServer) HasCallTimeoutS() bool {
	if o != nil && !IsNil(o.CallTimeoutS) {
		return true
	}

	return false
}

// SetCallTimeoutS gets a reference to the given float64 and assigns it to the CallTimeoutS field.
func (o *PolicyServer) SetCallTimeoutS(v float64) {
	o.CallTimeoutS = &v
}

// GetMaxConcurrent returns the MaxConcurrent field value if set, zero value otherwise.
func (o *PolicyServer) GetMaxConcurrent() int32 {
	if o == nil || IsNil(o.MaxConcurrent) {
		var ret int32
		return ret
	}
	return *o.MaxConcurrent
}

// GetMaxConcurrentOk returns a tuple with the MaxConcurrent field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetMaxConcurrentOk() (*int32, bool) {
	if o == nil || IsNil(o.MaxConcurrent) {
		return nil, false
	}
	return o.MaxConcurrent, true
}

// HasMaxConcurrent returns a boolean if a field has been set.
func (o *PolicyServer) HasMaxConcurrent() bool {
	if o != nil && !IsNil(o.MaxConcurrent) {
		return true
	}

	return false
}

// SetMaxConcurrent gets a reference to the given int32 and assigns it to the MaxConcurrent field.
func (o *PolicyServer) SetMaxConcurrent(v int32) {
	o.MaxConcurrent = &v
}

// GetMaxRetries returns the MaxRetries field value if set, zero value otherwise.
func (o *PolicyServer) GetMaxRetries() int32 {
	if o == nil || IsNil(o.MaxRetries) {
		var ret int32
		return ret
	}
	return *o.MaxRetries
}

// GetMaxRetriesOk returns a tuple with the MaxRetries field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetMaxRetriesOk() (*int32, bool) {
	if o == nil || IsNil(o.MaxRetries) {
		return nil, false
	}
	return o.MaxRetries, true
}

// HasMaxRetries returns a boolean if a field has been set.
func (o *PolicyServer) HasMaxRetries() bool {
	if o != nil && !IsNil(o.MaxRetries) {
		return true
	}

	return false
}

// SetMaxRetries gets a reference to the given int32 and assigns it to the MaxRetries field.
func (o *PolicyServer) SetMaxRetries(v int32) {
	o.MaxRetries = &v
}

// GetGeneration returns the Generation field value if set, zero value otherwise.
func (o *PolicyServer) GetGeneration() map[string]float64 {
	if o == nil || IsNil(o.Generation) {
		var ret map[string]float64
		return ret
	}
	return o.Generation
}

// GetGenerationOk returns a tuple with the Generation field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *PolicyServer) GetGenerationOk() (map[string]float64, bool) {
	if o == nil || IsNil(o.Generation) {
		return map[string]float64{}, false
	}
	return o.Generation, true
}

// HasGeneration returns a boolean if a field has been set.
func (o *PolicyServer) HasGeneration() bool {
	if o != nil && !IsNil(o.Generation) {
		return true
	}

	return false
}

// SetGeneration gets a reference to the given map[string]float64 and assigns it to the Generation field.
func (o *PolicyServer) SetGeneration(v map[string]float64) {
	o.Generation = v
}

func (o PolicyServer) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o PolicyServer) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["url"] = o.Url
	toSerialize["protocol"] = o.Protocol
	if !IsNil(o.ApiKey) {
		toSerialize["api_key"] = o.ApiKey
	}
	if !IsNil(o.Model) {
		toSerialize["model"] = o.Model
	}
	if !IsNil(o.CallTimeoutS) {
		toSerialize["call_timeout_s"] = o.CallTimeoutS
	}
	if !IsNil(o.MaxConcurrent) {
		toSerialize["max_concurrent"] = o.MaxConcurrent
	}
	if !IsNil(o.MaxRetries) {
		toSerialize["max_retries"] = o.MaxRetries
	}
	if !IsNil(o.Generation) {
		toSerialize["generation"] = o.Generation
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *PolicyServer) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"url",
		"protocol",
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

	varPolicyServer := _PolicyServer{}

	err = json.Unmarshal(data, &varPolicyServer)

	if err != nil {
		return err
	}

	*o = PolicyServer(varPolicyServer)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "url")
		delete(additionalProperties, "protocol")
		delete(additionalProperties, "api_key")
		delete(additionalProperties, "model")
		delete(additionalProperties, "call_timeout_s")
		delete(additionalProperties, "max_concurrent")
		delete(additionalProperties, "max_retries")
		delete(additionalProperties, "generation")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullablePolicyServer struct {
	value *PolicyServer
	isSet bool
}

func (v NullablePolicyServer) Get() *PolicyServer {
	return v.value
}

func (v *NullablePolicyServer) Set(val *PolicyServer) {
	v.value = val
	v.isSet = true
}

func (v NullablePolicyServer) IsSet() bool {
	return v.isSet
}

func (v *NullablePolicyServer) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullablePolicyServer(val *PolicyServer) *NullablePolicyServer {
	return &NullablePolicyServer{value: val, isSet: true}
}

func (v NullablePolicyServer) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullablePolicyServer) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
