// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ProtocolRange is a message of the protocol.
type ProtocolRange struct {
	Min string `json:"min" validate:"regexp=^[0-9]+\\.[0-9]+$"`
	Max string `json:"max" validate:"regexp=^[0-9]+\\.[0-9]+$"`
}
