// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// BoardEntryList is a message of the protocol.
type BoardEntryList struct {
	Entries []BoardEntry `json:"entries"`
	NextCursor NullableString `json:"next_cursor" validate:"regexp=^[A-Za-z0-9_-]{1\\,128}$"`
}
