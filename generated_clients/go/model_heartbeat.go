// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Heartbeat type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Heartbeat{}

// Heartbeat struct for Heartbeat
type Heartbeat struct {
	SessionId string `json:"session_id"`
	AdditionalProperties map[string]interface{}
}

type _Heartbeat Heartbeat

// NewHeartbeat instantiates a new Heartbeat object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewHeartbeat(sessionId string) *Heartbeat {
	this := Heartbeat{}
	this.SessionId = sessionId
	return &this
}

// NewHeartbeatWithDefaults instantiates a new Heartbeat object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewHeartbeatWithDefaults() *Heartbeat {
	this := Heartbeat{}
	return &this
}

// GetSessionId returns the SessionId field value
func (o *Heartbeat) GetSessionId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.SessionId
}

// GetSessionIdOk returns a tuple with the SessionId field value
// and a boolean to check if the value has been set.
func (o *Heartbeat) GetSessionIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SessionId, true
}

// SetSessionId sets field value
func (o *Heartbeat) SetSessionId(v string) {
	o.SessionId = v
}

func (o Heartbeat) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Heartbeat) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["session_id"] = o.SessionId

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Heartbeat) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"session_id",
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

	varHeartbeat := _Heartbeat{}

	err = json.Unmarshal(data, &varHeartbeat)

	if err != nil {
		return err
	}

	*o = Heartbeat(varHeartbeat)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "session_id")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableHeartbeat struct {
	value *Heartbeat
	isSet bool
}

func (v NullableHeartbeat) Get() *Heartbeat {
	return v.value
}

func (v *NullableHeartbeat) Set(val *Heartbeat) {
	v.value = val
	v.isSet = true
}

func (v NullableHeartbeat) IsSet() bool {
	return v.isSet
}

func (v *NullableHeartbeat) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableHeartbeat(val *Heartbeat) *NullableHeartbeat {
	return &NullableHeartbeat{value: val, isSet: true}
}

func (v NullableHeartbeat) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableHeartbeat) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
