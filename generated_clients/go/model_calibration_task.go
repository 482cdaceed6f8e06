// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// CalibrationTask the model 'CalibrationTask'
type CalibrationTask string

// List of CalibrationTask
const (
	CALIBRATIONTASK_SCORE CalibrationTask = "score"
	CALIBRATIONTASK_COUNT CalibrationTask = "count"
	CALIBRATIONTASK_ECHO CalibrationTask = "echo"
	CALIBRATIONTASK_DELAY CalibrationTask = "delay"
	CALIBRATIONTASK_FAULT CalibrationTask = "fault"
	CALIBRATIONTASK_UNKNOWN_DEFAULT_OPEN_API CalibrationTask = "unknown_default_open_api"
)

// All allowed values of CalibrationTask enum
var AllowedCalibrationTaskEnumValues = []CalibrationTask{
	"score",
	"count",
	"echo",
	"delay",
	"fault",
	"unknown_default_open_api",
}

func (v *CalibrationTask) UnmarshalJSON(src []byte) error {
	var value string
	err := json.Unmarshal(src, &value)
	if err != nil {
		return err
	}
	enumTypeValue := CalibrationTask(value)
	for _, existing := range AllowedCalibrationTaskEnumValues {
		if existing == enumTypeValue {
			*v = enumTypeValue
			return nil
		}
	}

	*v = CALIBRATIONTASK_UNKNOWN_DEFAULT_OPEN_API
	return nil
}

// NewCalibrationTaskFromValue returns a pointer to a valid CalibrationTask
// for the value passed as argument, or an error if the value passed is not allowed by the enum
func NewCalibrationTaskFromValue(v string) (*CalibrationTask, error) {
	ev := CalibrationTask(v)
	if ev.IsValid() {
		return &ev, nil
	} else {
		return nil, fmt.Errorf("invalid value '%v' for CalibrationTask: valid values are %v", v, AllowedCalibrationTaskEnumValues)
	}
}

// IsValid return true if the value is valid for the enum, false otherwise
func (v CalibrationTask) IsValid() bool {
	for _, existing := range AllowedCalibrationTaskEnumValues {
		if existing == v {
			return true
		}
	}
	return false
}

// Ptr returns reference to CalibrationTask value
func (v CalibrationTask) Ptr() *CalibrationTask {
	return &v
}

type NullableCalibrationTask struct {
	value *CalibrationTask
	isSet bool
}

func (v NullableCalibrationTask) Get() *CalibrationTask {
	return v.value
}

func (v *NullableCalibrationTask) Set(val *CalibrationTask) {
	v.value = val
	v.isSet = true
}

func (v NullableCalibrationTask) IsSet() bool {
	return v.isSet
}

func (v *NullableCalibrationTask) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableCalibrationTask(val *CalibrationTask) *NullableCalibrationTask {
	return &NullableCalibrationTask{value: val, isSet: true}
}

func (v NullableCalibrationTask) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableCalibrationTask) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
