// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Predict type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Predict{}

// Predict struct for Predict
type Predict struct {
	SessionId string `json:"session_id"`
	Seq int64 `json:"seq"`
	Actions []Action `json:"actions"`
	Observe *Observe `json:"observe,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _Predict Predict

// NewPredict instantiates a new Predict object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewPredict(sessionId string, seq int64, actions []Action) *Predict {
	this := Predict{}
	this.SessionId = sessionId
	this.Seq = seq
	this.Actions = actions
	return &this
}

// NewPredictWithDefaults instantiates a new Predict object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewPredictWithDefaults() *Predict {
	this := Predict{}
	return &this
}

// GetSessionId returns the SessionId field value
func (o *Predict) GetSessionId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.SessionId
}

// GetSessionIdOk returns a tuple with the SessionId field value
// and a boolean to check if the value has been set.
func (o *Predict) GetSessionIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SessionId, true
}

// SetSessionId sets field value
func (o *Predict) SetSessionId(v string) {
	o.SessionId = v
}

// GetSeq returns the Seq field value
func (o *Predict) GetSeq() int64 {
	if o == nil {
		var ret int64
		return ret
	}

	return o.Seq
}

// GetSeqOk returns a tuple with the Seq field value
// and a boolean to check if the value has been set.
func (o *Predict) GetSeqOk() (*int64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Seq, true
}

// SetSeq sets field value
func (o *Predict) SetSeq(v int64) {
	o.Seq = v
}

// GetActions returns the Actions field value
func (o *Predict) GetActions() []Action {
	if o == nil {
		var ret []Action
		return ret
	}

	return o.Actions
}

// GetActionsOk returns a tuple with the Actions field value
// and a boolean to check if the value has been set.
func (o *Predict) GetActionsOk() ([]Action, bool) {
	if o == nil {
		return nil, false
	}
	return o.Actions, true
}

// SetActions sets field value
func (o *Predict) SetActions(v []Action) {
	o.Actions = v
}

// GetObserve returns the Observe field value if set, zero value otherwise.
func (o *Predict) GetObserve() Observe {
	if o == nil || IsNil(o.Observe) {
		var ret Observe
		return ret
	}
	return *o.Observe
}

// GetObserveOk returns a tuple with the Observe field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Predict) GetObserveOk() (*Observe, bool) {
	if o == nil || IsNil(o.Observe) {
		return nil, false
	}
	return o.Observe, true
}

// HasObserve returns a boolean if a field has been set.
func (o *Predict) HasObserve() bool {
	if o != nil && !IsNil(o.Observe) {
		return true
	}

	return false
}

// SetObserve gets a reference to the given Observe and assigns it to the Observe field.
func (o *Predict) SetObserve(v Observe) {
	o.Observe = &v
}

func (o Predict) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Predict) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["session_id"] = o.SessionId
	toSerialize["seq"] = o.Seq
	toSerialize["actions"] = o.Actions
	if !IsNil(o.Observe) {
		toSerialize["observe"] = o.Observe
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Predict) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"session_id",
		"seq",
		"actions",
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

	varPredict := _Predict{}

	err = json.Unmarshal(data, &varPredict)

	if err != nil {
		return err
	}

	*o = Predict(varPredict)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "session_id")
		delete(additionalProperties, "seq")
		delete(additionalProperties, "actions")
		delete(additionalProperties, "observe")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullablePredict struct {
	value *Predict
	isSet bool
}

func (v NullablePredict) Get() *Predict {
	return v.value
}

func (v *NullablePredict) Set(val *Predict) {
	v.value = val
	v.isSet = true
}

func (v NullablePredict) IsSet() bool {
	return v.isSet
}

func (v *NullablePredict) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullablePredict(val *Predict) *NullablePredict {
	return &NullablePredict{value: val, isSet: true}
}

func (v NullablePredict) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullablePredict) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
