// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// StopMode `abort` when absent.
type StopMode string

const (
	STOPMODE_ABORT StopMode = "abort"
	STOPMODE_DRAIN StopMode = "drain"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v StopMode) Ptr() *StopMode {
	return &v
}
