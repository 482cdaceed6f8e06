// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// FlagEntry is a message of the protocol.
type FlagEntry struct {
	// False takes the flag back.
	Flagged bool `json:"flagged"`
	// For everybody to read.
	Reason string `json:"reason"`
}
