// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Observation is a message of the protocol.
type Observation struct {
	State map[string][]float64 `json:"state"`
	Images map[string]Image `json:"images"`
	Tensors map[string]Tensor `json:"tensors"`
}
