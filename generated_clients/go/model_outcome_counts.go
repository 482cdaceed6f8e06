// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// OutcomeCounts is a message of the protocol.
type OutcomeCounts struct {
	Total int32 `json:"total"`
	Success int32 `json:"success"`
	Failure int32 `json:"failure"`
	Abandoned int32 `json:"abandoned"`
	Unscored int32 `json:"unscored"`
}
