// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// EpisodeStatus the model 'EpisodeStatus'
type EpisodeStatus string

// List of EpisodeStatus
const (
	EPISODESTATUS_PENDING EpisodeStatus = "pending"
	EPISODESTATUS_IN_PROGRESS EpisodeStatus = "in_progress"
	EPISODESTATUS_SCORED EpisodeStatus = "scored"
	EPISODESTATUS_UNKNOWN_DEFAULT_OPEN_API EpisodeStatus = "unknown_default_open_api"
)

// All allowed values of EpisodeStatus enum
var AllowedEpisodeStatusEnumValues = []EpisodeStatus{
	"pending",
	"in_progress",
	"scored",
	"unknown_default_open_api",
}

func (v *EpisodeStatus) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := EpisodeStatus(value)
	for _, existing := range AllowedEpisodeStatusEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = EPISODESTATUS_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewEpisodeStatusFromValue returns a pointer to a valid EpisodeStatus
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewEpisodeStatusFromValue(v string) (*EpisodeStatus, error) {
	ev := EpisodeStatus(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for EpisodeStatus: valid values are %v", v, AllowedEpisodeStatusEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v EpisodeStatus) IsValid() bool {
	for _, existing := range AllowedEpisodeStatusEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to EpisodeStatus value
func (v EpisodeStatus) Ptr() *EpisodeStatus {
	return &v
}

type NullableEpisodeStatus struct {
	value *EpisodeStatus
	isSet bool
}

func (v NullableEpisodeStatus) Get() *EpisodeStatus {
	return v.value
}

func (v *NullableEpisodeStatus) Set(val *EpisodeStatus) {
	v.value = val
	v.isSet = true
}

func (v NullableEpisodeStatus) IsSet() bool {
	return v.isSet
}

func (v *NullableEpisodeStatus) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableEpisodeStatus(val *EpisodeStatus) *NullableEpisodeStatus {
	return &NullableEpisodeStatus{value: val, isSet: true}
}

func (v NullableEpisodeStatus) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableEpisodeStatus) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
