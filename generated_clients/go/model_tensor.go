// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Tensor C order, little-endian; a bool is one byte, 0 or 1.
type Tensor struct {
	Dtype string `json:"dtype" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Shape []int64 `json:"shape"`
	// Base64 with padding in JSON; `bin` in MessagePack.
	Data string `json:"data"`
}
