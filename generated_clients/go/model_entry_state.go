// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// EntryState is a list that later minor versions do not extend.
type EntryState string

const (
	ENTRYSTATE_PUBLISHED EntryState = "published"
	ENTRYSTATE_WITHDRAWN EntryState = "withdrawn"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v EntryState) Ptr() *EntryState {
	return &v
}
