// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// CalibrationTask is a list that later minor versions do not extend.
type CalibrationTask string

const (
	CALIBRATIONTASK_SCORE CalibrationTask = "score"
	CALIBRATIONTASK_COUNT CalibrationTask = "count"
	CALIBRATIONTASK_ECHO CalibrationTask = "echo"
	CALIBRATIONTASK_DELAY CalibrationTask = "delay"
	CALIBRATIONTASK_FAULT CalibrationTask = "fault"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v CalibrationTask) Ptr() *CalibrationTask {
	return &v
}
