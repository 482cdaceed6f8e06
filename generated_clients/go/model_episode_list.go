// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// EpisodeList is a message of the protocol.
type EpisodeList struct {
	Episodes []Episode `json:"episodes"`
	NextCursor NullableString `json:"next_cursor" validate:"regexp=^[A-Za-z0-9_-]{1\\,128}$"`
}
