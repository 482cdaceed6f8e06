// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Observe `last` when absent; `all` adds the observation after every executed action.
type Observe string

const (
	OBSERVE_LAST Observe = "last"
	OBSERVE_ALL Observe = "all"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v Observe) Ptr() *Observe {
	return &v
}
