// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// BoardEntryList is a message of the protocol.
type BoardEntryList struct {
	Entries []BoardEntry `json:"entries"`
	NextCursor NullableString `json:"next_cursor"`
}
