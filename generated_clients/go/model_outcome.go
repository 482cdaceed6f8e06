// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// Outcome the model 'Outcome'
type Outcome string

// List of Outcome
const (
	OUTCOME_SUCCESS Outcome = "success"
	OUTCOME_FAILURE Outcome = "failure"
	OUTCOME_ABANDONED Outcome = "abandoned"
	OUTCOME_UNKNOWN_DEFAULT_OPEN_API Outcome = "unknown_default_open_api"
)

// All allowed values of Outcome enum
var AllowedOutcomeEnumValues = []Outcome{
	"success",
	"failure",
	"abandoned",
	"unknown_default_open_api",
}

func (v *Outcome) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := Outcome(value)
	for _, existing := range AllowedOutcomeEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = OUTCOME_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewOutcomeFromValue returns a pointer to a valid Outcome
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewOutcomeFromValue(v string) (*Outcome, error) {
	ev := Outcome(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for Outcome: valid values are %v", v, AllowedOutcomeEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v Outcome) IsValid() bool {
	for _, existing := range AllowedOutcomeEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to Outcome value
func (v Outcome) Ptr() *Outcome {
	return &v
}

type NullableOutcome struct {
	value *Outcome
	isSet bool
}

func (v NullableOutcome) Get() *Outcome {
	return v.value
}

func (v *NullableOutcome) Set(val *Outcome) {
	v.value = val
	v.isSet = true
}

func (v NullableOutcome) IsSet() bool {
	return v.isSet
}

func (v *NullableOutcome) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableOutcome(val *Outcome) *NullableOutcome {
	return &NullableOutcome{value: val, isSet: true}
}

func (v NullableOutcome) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableOutcome) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
