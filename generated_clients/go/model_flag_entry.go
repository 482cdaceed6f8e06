// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// FlagEntry is a message of the protocol.
type FlagEntry struct {
	// False takes the flag back.
	Flagged bool `json:"flagged"`
	// Shown with the entry.
	Reason string `json:"reason"`
}
