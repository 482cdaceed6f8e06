// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Outcome is a list that later minor versions do not extend.
type Outcome string

const (
	OUTCOME_SUCCESS Outcome = "success"
	OUTCOME_FAILURE Outcome = "failure"
	OUTCOME_ABANDONED Outcome = "abandoned"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v Outcome) Ptr() *Outcome {
	return &v
}
