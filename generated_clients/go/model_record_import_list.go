// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RecordImportList is a message of the protocol.
type RecordImportList struct {
	Imports []RecordImport `json:"imports"`
	NextCursor NullableString `json:"next_cursor"`
}
