// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// HistoryPage is a message of the protocol.
type HistoryPage struct {
	Leaves []HistoryLeaf `json:"leaves"`
	NextCursor NullableString `json:"next_cursor" validate:"regexp=^[A-Za-z0-9_-]{1\\,128}$"`
}
