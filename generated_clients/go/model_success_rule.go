// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// SuccessRule the model 'SuccessRule'
type SuccessRule string

// List of SuccessRule
const (
	SUCCESSRULE_ANY_STEP SuccessRule = "any_step"
	SUCCESSRULE_LAST_STEP SuccessRule = "last_step"
	SUCCESSRULE_UNKNOWN_DEFAULT_OPEN_API SuccessRule = "unknown_default_open_api"
)

// All allowed values of SuccessRule enum
var AllowedSuccessRuleEnumValues = []SuccessRule{
	"any_step",
	"last_step",
	"unknown_default_open_api",
}

func (v *SuccessRule) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := SuccessRule(value)
	for _, existing := range AllowedSuccessRuleEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = SUCCESSRULE_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewSuccessRuleFromValue returns a pointer to a valid SuccessRule
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewSuccessRuleFromValue(v string) (*SuccessRule, error) {
	ev := SuccessRule(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for SuccessRule: valid values are %v", v, AllowedSuccessRuleEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v SuccessRule) IsValid() bool {
	for _, existing := range AllowedSuccessRuleEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to SuccessRule value
func (v SuccessRule) Ptr() *SuccessRule {
	return &v
}

type NullableSuccessRule struct {
	value *SuccessRule
	isSet bool
}

func (v NullableSuccessRule) Get() *SuccessRule {
	return v.value
}

func (v *NullableSuccessRule) Set(val *SuccessRule) {
	v.value = val
	v.isSet = true
}

func (v NullableSuccessRule) IsSet() bool {
	return v.isSet
}

func (v *NullableSuccessRule) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableSuccessRule(val *SuccessRule) *NullableSuccessRule {
	return &NullableSuccessRule{value: val, isSet: true}
}

func (v NullableSuccessRule) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableSuccessRule) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
