// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Heartbeat is a message of the protocol.
type Heartbeat struct {
	SessionId string `json:"session_id"`
}
