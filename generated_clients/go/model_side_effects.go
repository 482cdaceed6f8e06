// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// SideEffects is a list that later minor versions do not extend.
type SideEffects string

const (
	SIDEEFFECTS_NONE SideEffects = "none"
	SIDEEFFECTS_POSSIBLE SideEffects = "possible"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v SideEffects) Ptr() *SideEffects {
	return &v
}
