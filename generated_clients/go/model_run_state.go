// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RunState is a list that later minor versions do not extend.
type RunState string

const (
	RUNSTATE_QUEUED RunState = "queued"
	RUNSTATE_READY RunState = "ready"
	RUNSTATE_RUNNING RunState = "running"
	RUNSTATE_STOPPING RunState = "stopping"
	RUNSTATE_STOPPED RunState = "stopped"
	RUNSTATE_FAILED RunState = "failed"
	RUNSTATE_COMPLETED RunState = "completed"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v RunState) Ptr() *RunState {
	return &v
}
