// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RunList is a message of the protocol.
type RunList struct {
	Runs []Run `json:"runs"`
	NextCursor NullableString `json:"next_cursor" validate:"regexp=^[A-Za-z0-9_-]{1\\,128}$"`
}
