// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RunMode `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own.
type RunMode string

const (
	RUNMODE_PULL RunMode = "pull"
	RUNMODE_PUSH RunMode = "push"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v RunMode) Ptr() *RunMode {
	return &v
}
