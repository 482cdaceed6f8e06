// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// Lease is a message of the protocol.
type Lease struct {
	ExpiresAt time.Time `json:"expires_at"`
	IdleTimeoutS float64 `json:"idle_timeout_s"`
}
