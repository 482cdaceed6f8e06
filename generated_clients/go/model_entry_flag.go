// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// EntryFlag is a message of the protocol.
type EntryFlag struct {
	Reason string `json:"reason"`
	FlaggedAt time.Time `json:"flagged_at"`
}
