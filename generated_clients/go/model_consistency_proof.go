// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ConsistencyProof is a message of the protocol.
type ConsistencyProof struct {
	OldSize int64 `json:"old_size"`
	NewSize int64 `json:"new_size"`
	Hashes []string `json:"hashes"`
}
