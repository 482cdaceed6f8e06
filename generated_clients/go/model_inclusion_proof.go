// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// InclusionProof is a message of the protocol.
type InclusionProof struct {
	LeafIndex int64 `json:"leaf_index"`
	TreeSize int64 `json:"tree_size"`
	Hashes []string `json:"hashes"`
}
