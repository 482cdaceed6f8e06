// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// GroupScore is a message of the protocol.
type GroupScore struct {
	Counts OutcomeCounts `json:"counts"`
	Mean NullableFloat64 `json:"mean"`
	SuccessRate NullableFloat64 `json:"success_rate"`
}
