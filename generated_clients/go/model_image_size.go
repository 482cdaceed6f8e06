// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ImageSize is a message of the protocol.
type ImageSize struct {
	Width int32 `json:"width"`
	Height int32 `json:"height"`
}
