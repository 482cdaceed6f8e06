// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ObservationSpace is a message of the protocol.
type ObservationSpace struct {
	State map[string]VectorSpace `json:"state"`
	Images map[string]ImageSpace `json:"images"`
	Tensors map[string]TensorSpace `json:"tensors"`
}
