// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RecordImportList is a message of the protocol.
type RecordImportList struct {
	Imports []RecordImport `json:"imports"`
	NextCursor NullableString `json:"next_cursor" validate:"regexp=^[A-Za-z0-9_-]{1\\,128}$"`
}
