// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// PublicKey is a message of the protocol.
type PublicKey struct {
	// `SHA256:` and the SHA-256 of the key in hexadecimal digits.
	Keyid string `json:"keyid"`
	// `ed25519`, or another one of a later version.
	Algorithm string `json:"algorithm"`
	// Its 32 bytes.
	PublicKey string `json:"public_key"`
	CreatedAt time.Time `json:"created_at"`
	// When it signed for the last time; null for the key in use.
	RetiredAt NullableTime `json:"retired_at"`
}
