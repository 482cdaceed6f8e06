// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Problem RFC 9457, with what a client needs to decide on a retry.
type Problem struct {
	Type string `json:"type"`
	Title string `json:"title"`
	Status int32 `json:"status"`
	// What happened and what to do about it.
	Detail string `json:"detail"`
	// One of x-problems, or one of a later version.
	Code string `json:"code"`
	// Whether the same request can succeed later.
	Retryable bool `json:"retryable"`
	SideEffects SideEffects `json:"side_effects"`
	Errors []ProblemItem `json:"errors,omitzero"`
	// Id of the rule that was enforced.
	Requirement *string `json:"requirement,omitzero" validate:"regexp=[A-Z]+-[0-9]+"`
	State *RunState `json:"state,omitzero"`
	ExpectedSeq *int64 `json:"expected_seq,omitzero"`
	// What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
	EndedBy *string `json:"ended_by,omitzero" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
}

// GetErrors returns errors, or the zero value when it is absent.
func (o *Problem) GetErrors() (v []ProblemItem) {
	if o != nil && o.Errors != nil {
		v = o.Errors
	}
	return v
}

// SetErrors sets errors.
func (o *Problem) SetErrors(v []ProblemItem) {
	o.Errors = v
}

// GetRequirement returns requirement, or the zero value when it is absent.
func (o *Problem) GetRequirement() (v string) {
	if o != nil && o.Requirement != nil {
		v = *o.Requirement
	}
	return v
}

// SetRequirement sets requirement.
func (o *Problem) SetRequirement(v string) {
	o.Requirement = &v
}

// GetState returns state, or the zero value when it is absent.
func (o *Problem) GetState() (v RunState) {
	if o != nil && o.State != nil {
		v = *o.State
	}
	return v
}

// SetState sets state.
func (o *Problem) SetState(v RunState) {
	o.State = &v
}

// GetExpectedSeq returns expected_seq, or the zero value when it is absent.
func (o *Problem) GetExpectedSeq() (v int64) {
	if o != nil && o.ExpectedSeq != nil {
		v = *o.ExpectedSeq
	}
	return v
}

// SetExpectedSeq sets expected_seq.
func (o *Problem) SetExpectedSeq(v int64) {
	o.ExpectedSeq = &v
}

// GetEndedBy returns ended_by, or the zero value when it is absent.
func (o *Problem) GetEndedBy() (v string) {
	if o != nil && o.EndedBy != nil {
		v = *o.EndedBy
	}
	return v
}

// SetEndedBy sets ended_by.
func (o *Problem) SetEndedBy(v string) {
	o.EndedBy = &v
}
