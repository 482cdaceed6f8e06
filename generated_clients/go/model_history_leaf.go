// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// HistoryLeaf is a message of the protocol.
type HistoryLeaf struct {
	Index int64 `json:"index"`
	// A JSON text, whose UTF-8 is what the tree has; board.md has its members.
	Leaf string `json:"leaf"`
}
