// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// SuccessRule is a list that later minor versions do not extend.
type SuccessRule string

const (
	SUCCESSRULE_ANY_STEP SuccessRule = "any_step"
	SUCCESSRULE_LAST_STEP SuccessRule = "last_step"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v SuccessRule) Ptr() *SuccessRule {
	return &v
}
