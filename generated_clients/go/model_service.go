// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// Service What a server says of itself before anyone authenticates.
type Service struct {
	Name string `json:"name"`
	// Version of the server software.
	Version string `json:"version"`
	Protocol ProtocolRange `json:"protocol"`
	// Parts of the protocol offered; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these.
	Profiles []string `json:"profiles"`
	Limits Limits `json:"limits"`
	// Media types of the data plane.
	Encodings []string `json:"encodings"`
	ImageCodecs []string `json:"image_codecs"`
	// The server's clock, UTC.
	ServerTime time.Time `json:"server_time"`
}
