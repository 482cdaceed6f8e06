// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ProblemItem is a message of the protocol.
type ProblemItem struct {
	// JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record.
	Pointer string `json:"pointer"`
	Detail string `json:"detail"`
}
