// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// Profile the model 'Profile'
type Profile string

// List of Profile
const (
	PROFILE_CORE Profile = "core"
	PROFILE_MSGPACK Profile = "msgpack"
	PROFILE_COMPARE Profile = "compare"
	PROFILE_EVENTS Profile = "events"
	PROFILE_PUSH Profile = "push"
	PROFILE_EBENCH Profile = "ebench"
	PROFILE_FLAGEVAL Profile = "flageval"
	PROFILE_UNKNOWN_DEFAULT_OPEN_API Profile = "unknown_default_open_api"
)

// All allowed values of Profile enum
var AllowedProfileEnumValues = []Profile{
	"core",
	"msgpack",
	"compare",
	"events",
	"push",
	"ebench",
	"flageval",
	"unknown_default_open_api",
}

func (v *Profile) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := Profile(value)
	for _, existing := range AllowedProfileEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = PROFILE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewProfileFromValue returns a pointer to a valid Profile
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewProfileFromValue(v string) (*Profile, error) {
	ev := Profile(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for Profile: valid values are %v", v, AllowedProfileEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v Profile) IsValid() bool {
	for _, existing := range AllowedProfileEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to Profile value
func (v Profile) Ptr() *Profile {
	return &v
}

type NullableProfile struct {
	value *Profile
	isSet bool
}

func (v NullableProfile) Get() *Profile {
	return v.value
}

func (v *NullableProfile) Set(val *Profile) {
	v.value = val
	v.isSet = true
}

func (v NullableProfile) IsSet() bool {
	return v.isSet
}

func (v *NullableProfile) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableProfile(val *Profile) *NullableProfile {
	return &NullableProfile{value: val, isSet: true}
}

func (v NullableProfile) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableProfile) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
