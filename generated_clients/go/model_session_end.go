// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// SessionEnd What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
type SessionEnd string

// List of SessionEnd
const (
	SESSIONEND_LEASE_ENDED SessionEnd = "lease_ended"
	SESSIONEND_DETACHED SessionEnd = "detached"
	SESSIONEND_RUN_STOPPED SessionEnd = "run_stopped"
	SESSIONEND_RUN_FAILED SessionEnd = "run_failed"
	SESSIONEND_UNKNOWN SessionEnd = "unknown"
	SESSIONEND_UNKNOWN_DEFAULT_OPEN_API SessionEnd = "unknown_default_open_api"
)

// All allowed values of SessionEnd enum
var AllowedSessionEndEnumValues = []SessionEnd{
	"lease_ended",
	"detached",
	"run_stopped",
	"run_failed",
	"unknown",
	"unknown_default_open_api",
}

func (v *SessionEnd) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := SessionEnd(value)
	for _, existing := range AllowedSessionEndEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = SESSIONEND_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewSessionEndFromValue returns a pointer to a valid SessionEnd
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewSessionEndFromValue(v string) (*SessionEnd, error) {
	ev := SessionEnd(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for SessionEnd: valid values are %v", v, AllowedSessionEndEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v SessionEnd) IsValid() bool {
	for _, existing := range AllowedSessionEndEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to SessionEnd value
func (v SessionEnd) Ptr() *SessionEnd {
	return &v
}

type NullableSessionEnd struct {
	value *SessionEnd
	isSet bool
}

func (v NullableSessionEnd) Get() *SessionEnd {
	return v.value
}

func (v *NullableSessionEnd) Set(val *SessionEnd) {
	v.value = val
	v.isSet = true
}

func (v NullableSessionEnd) IsSet() bool {
	return v.isSet
}

func (v *NullableSessionEnd) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableSessionEnd(val *SessionEnd) *NullableSessionEnd {
	return &NullableSessionEnd{value: val, isSet: true}
}

func (v NullableSessionEnd) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableSessionEnd) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
