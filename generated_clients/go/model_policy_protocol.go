// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// PolicyProtocol `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words.
type PolicyProtocol string

// List of PolicyProtocol
const (
	POLICYPROTOCOL_PROCTOR PolicyProtocol = "proctor"
	POLICYPROTOCOL_OPENAI_CHAT PolicyProtocol = "openai_chat"
	POLICYPROTOCOL_UNKNOWN_DEFAULT_OPEN_API PolicyProtocol = "unknown_default_open_api"
)

// All allowed values of PolicyProtocol enum
var AllowedPolicyProtocolEnumValues = []PolicyProtocol{
	"proctor",
	"openai_chat",
	"unknown_default_open_api",
}

func (v *PolicyProtocol) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := PolicyProtocol(value)
	for _, existing := range AllowedPolicyProtocolEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = POLICYPROTOCOL_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewPolicyProtocolFromValue returns a pointer to a valid PolicyProtocol
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewPolicyProtocolFromValue(v string) (*PolicyProtocol, error) {
	ev := PolicyProtocol(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for PolicyProtocol: valid values are %v", v, AllowedPolicyProtocolEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v PolicyProtocol) IsValid() bool {
	for _, existing := range AllowedPolicyProtocolEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to PolicyProtocol value
func (v PolicyProtocol) Ptr() *PolicyProtocol {
	return &v
}

type NullablePolicyProtocol struct {
	value *PolicyProtocol
	isSet bool
}

func (v NullablePolicyProtocol) Get() *PolicyProtocol {
	return v.value
}

func (v *NullablePolicyProtocol) Set(val *PolicyProtocol) {
	v.value = val
	v.isSet = true
}

func (v NullablePolicyProtocol) IsSet() bool {
	return v.isSet
}

func (v *NullablePolicyProtocol) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullablePolicyProtocol(val *PolicyProtocol) *NullablePolicyProtocol {
	return &NullablePolicyProtocol{value: val, isSet: true}
}

func (v NullablePolicyProtocol) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullablePolicyProtocol) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
