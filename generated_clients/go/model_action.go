// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Action is a message of the protocol.
type Action struct {
	// Name → vector, exactly the entries of the benchmark's action space.
	Values map[string][]float64 `json:"values"`
}
