// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Limits type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Limits{}

// Limits struct for Limits
type Limits struct {
	// Longest request body that is read.
	MaxBodyBytes int64 `json:"max_body_bytes"`
	// Most live workers a run may ask for.
	MaxWorkers int32 `json:"max_workers"`
	// Most actions in one predict; a benchmark may allow fewer.
	MaxChunk int32 `json:"max_chunk"`
	IdleTimeoutSMin float64 `json:"idle_timeout_s_min"`
	IdleTimeoutSMax float64 `json:"idle_timeout_s_max"`
	// Longest wait that a long-poll is granted.
	WaitSMax int32 `json:"wait_s_max"`
	AdditionalProperties map[string]interface{}
}

type _Limits Limits

// NewLimits instantiates a new Limits object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewLimits(maxBodyBytes int64, maxWorkers int32, maxChunk int32, idleTimeoutSMin float64, idleTimeoutSMax float64, waitSMax int32) *Limits {
	this := Limits{}
	this.MaxBodyBytes = maxBodyBytes
	this.MaxWorkers = maxWorkers
	this.MaxChunk = maxChunk
	this.IdleTimeoutSMin = idleTimeoutSMin
	this.IdleTimeoutSMax = idleTimeoutSMax
	this.WaitSMax = waitSMax
	return &this
}

// NewLimitsWithDefaults instantiates a new Limits object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewLimitsWithDefaults() *Limits {
	this := Limits{}
	return &this
}

// GetMaxBodyBytes returns the MaxBodyBytes field value
func (o *Limits) GetMaxBodyBytes() int64 {
	if o == nil {
		var ret int64
		return ret
	}

	return o.MaxBodyBytes
}

// GetMaxBodyBytesOk returns a tuple with the MaxBodyBytes field value
// and a boolean to check if the value has been set.
func (o *Limits) GetMaxBodyBytesOk() (*int64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxBodyBytes, true
}

// SetMaxBodyBytes sets field value
func (o *Limits) SetMaxBodyBytes(v int64) {
	o.MaxBodyBytes = v
}

// GetMaxWorkers returns the MaxWorkers field value
func (o *Limits) GetMaxWorkers() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxWorkers
}

// GetMaxWorkersOk returns a tuple with the MaxWorkers field value
// and a boolean to check if the value has been set.
func (o *Limits) GetMaxWorkersOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxWorkers, true
}

// SetMaxWorkers sets field value
func (o *Limits) SetMaxWorkers(v int32) {
	o.MaxWorkers = v
}

// GetMaxChunk returns the MaxChunk field value
func (o *Limits) GetMaxChunk() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxChunk
}

// GetMaxChunkOk returns a tuple with the MaxChunk field value
// and a boolean to check if the value has been set.
func (o *Limits) GetMaxChunkOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxChunk, true
}

// SetMaxChunk sets field value
func (o *Limits) SetMaxChunk(v int32) {
	o.MaxChunk = v
}

// GetIdleTimeoutSMin returns the IdleTimeoutSMin field value
func (o *Limits) GetIdleTimeoutSMin() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.IdleTimeoutSMin
}

// GetIdleTimeoutSMinOk returns a tuple with the IdleTimeoutSMin field value
// and a boolean to check if the value has been set.
func (o *Limits) GetIdleTimeoutSMinOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.IdleTimeoutSMin, true
}

// SetIdleTimeoutSMin sets field value
func (o *Limits) SetIdleTimeoutSMin(v float64) {
	o.IdleTimeoutSMin = v
}

// GetIdleTimeoutSMax returns the IdleTimeoutSMax field value
func (o *Limits) GetIdleTimeoutSMax() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.IdleTimeoutSMax
}

// GetIdleTimeoutSMaxOk returns a tuple with the IdleTimeoutSMax field value
// and a boolean to check if the value has been set.
func (o *Limits) GetIdleTimeoutSMaxOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.IdleTimeoutSMax, true
}

// SetIdleTimeoutSMax sets field value
func (o *Limits) SetIdleTimeoutSMax(v float64) {
	o.IdleTimeoutSMax = v
}

// GetWaitSMax returns the WaitSMax field value
func (o *Limits) GetWaitSMax() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.WaitSMax
}

// GetWaitSMaxOk returns a tuple with the WaitSMax field value
// and a boolean to check if the value has been set.
func (o *Limits) GetWaitSMaxOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.WaitSMax, true
}

// SetWaitSMax sets field value
func (o *Limits) SetWaitSMax(v int32) {
	o.WaitSMax = v
}

func (o Limits) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Limits) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["max_body_bytes"] = o.MaxBodyBytes
	toSerialize["max_workers"] = o.MaxWorkers
	toSerialize["max_chunk"] = o.MaxChunk
	toSerialize["idle_timeout_s_min"] = o.IdleTimeoutSMin
	toSerialize["idle_timeout_s_max"] = o.IdleTimeoutSMax
	toSerialize["wait_s_max"] = o.WaitSMax

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Limits) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"max_body_bytes",
		"max_workers",
		"max_chunk",
		"idle_timeout_s_min",
		"idle_timeout_s_max",
		"wait_s_max",
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

	varLimits := _Limits{}

	err = json.Unmarshal(data, &varLimits)

	if err != nil {
		return err
	}

	*o = Limits(varLimits)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "max_body_bytes")
		delete(additionalProperties, "max_workers")
		delete(additionalProperties, "max_chunk")
		delete(additionalProperties, "idle_timeout_s_min")
		delete(additionalProperties, "idle_timeout_s_max")
		delete(additionalProperties, "wait_s_max")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableLimits struct {
	value *Limits
	isSet bool
}

func (v NullableLimits) Get() *Limits {
	return v.value
}

func (v *NullableLimits) Set(val *Limits) {
	v.value = val
	v.isSet = true
}

func (v NullableLimits) IsSet() bool {
	return v.isSet
}

func (v *NullableLimits) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableLimits(val *Limits) *NullableLimits {
	return &NullableLimits{value: val, isSet: true}
}

func (v NullableLimits) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableLimits) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
