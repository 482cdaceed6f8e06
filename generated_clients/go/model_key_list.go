// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// KeyList is a message of the protocol.
type KeyList struct {
	Keys []PublicKey `json:"keys"`
}
