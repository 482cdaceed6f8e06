// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the PolicyReset type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &PolicyReset{}

// PolicyReset The policy is ready for this attempt and no other.
type PolicyReset struct {
	SessionId string `json:"session_id"`
	EpisodeId string `json:"episode_id"`
	Attempt int32 `json:"attempt"`
	AdditionalProperties map[string]interface{}
}

type _PolicyReset PolicyReset

// NewPolicyReset instantiates a new PolicyReset object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewPolicyReset(sessionId string, episodeId string, attempt int32) *PolicyReset {
	this := PolicyReset{}
	this.SessionId = sessionId
	this.EpisodeId = episodeId
	this.Attempt = attempt
	return &this
}

// NewPolicyResetWithDefaults instantiates a new PolicyReset object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewPolicyResetWithDefaults() *PolicyReset {
	this := PolicyReset{}
	return &this
}

// GetSessionId returns the SessionId field value
func (o *PolicyReset) GetSessionId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.SessionId
}

// GetSessionIdOk returns a tuple with the SessionId field value
// and a boolean to check if the value has been set.
func (o *PolicyReset) GetSessionIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SessionId, true
}

// SetSessionId sets field value
func (o *PolicyReset) SetSessionId(v string) {
	o.SessionId = v
}

// GetEpisodeId returns the EpisodeId field value
func (o *PolicyReset) GetEpisodeId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.EpisodeId
}

// GetEpisodeIdOk returns a tuple with the EpisodeId field value
// and a boolean to check if the value has been set.
func (o *PolicyReset) GetEpisodeIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodeId, true
}

// SetEpisodeId sets field value
func (o *PolicyReset) SetEpisodeId(v string) {
	o.EpisodeId = v
}

// GetAttempt returns the Attempt field value
func (o *PolicyReset) GetAttempt() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Attempt
}

// GetAttemptOk returns a tuple with the Attempt field value
// and a boolean to check if the value has been set.
func (o *PolicyReset) GetAttemptOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Attempt, true
}

// SetAttempt sets field value
func (o *PolicyReset) SetAttempt(v int32) {
	o.Attempt = v
}

func (o PolicyReset) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o PolicyReset) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["session_id"] = o.SessionId
	toSerialize["episode_id"] = o.EpisodeId
	toSerialize["attempt"] = o.Attempt

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *PolicyReset) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"session_id",
		"episode_id",
		"attempt",
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

	varPolicyReset := _PolicyReset{}

	err = json.Unmarshal(data, &varPolicyReset)

	if err != nil {
		return err
	}

	*o = PolicyReset(varPolicyReset)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "session_id")
		delete(additionalProperties, "episode_id")
		delete(additionalProperties, "attempt")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullablePolicyReset struct {
	value *PolicyReset
	isSet bool
}

func (v NullablePolicyReset) Get() *PolicyReset {
	return v.value
}

func (v *NullablePolicyReset) Set(val *PolicyReset) {
	v.value = val
	v.isSet = true
}

func (v NullablePolicyReset) IsSet() bool {
	return v.isSet
}

func (v *NullablePolicyReset) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullablePolicyReset(val *PolicyReset) *NullablePolicyReset {
	return &NullablePolicyReset{value: val, isSet: true}
}

func (v NullablePolicyReset) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullablePolicyReset) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
