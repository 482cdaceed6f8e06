// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ImportedPolicy is a message of the protocol.
type ImportedPolicy struct {
	Name string `json:"name"`
	Version NullableString `json:"version"`
}
