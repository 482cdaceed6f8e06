// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ComparedTask is a message of the protocol.
type ComparedTask struct {
	Paired int32 `json:"paired"`
	BaselineMean NullableFloat64 `json:"baseline_mean"`
	Mean NullableFloat64 `json:"mean"`
	Difference NullableFloat64 `json:"difference"`
}
