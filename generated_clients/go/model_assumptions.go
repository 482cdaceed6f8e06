// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Assumptions What the policy takes for granted; refused when the benchmark says otherwise (ATT-010).
type Assumptions struct {
	ControlRateHz *float64 `json:"control_rate_hz,omitzero"`
	Action map[string]Assumption `json:"action,omitzero"`
	State map[string]Assumption `json:"state,omitzero"`
}

// GetControlRateHz returns control_rate_hz, or the zero value when it is absent.
func (o *Assumptions) GetControlRateHz() (v float64) {
	if o != nil && o.ControlRateHz != nil {
		v = *o.ControlRateHz
	}
	return v
}

// SetControlRateHz sets control_rate_hz.
func (o *Assumptions) SetControlRateHz(v float64) {
	o.ControlRateHz = &v
}

// GetAction returns action, or the zero value when it is absent.
func (o *Assumptions) GetAction() (v map[string]Assumption) {
	if o != nil && o.Action != nil {
		v = o.Action
	}
	return v
}

// SetAction sets action.
func (o *Assumptions) SetAction(v map[string]Assumption) {
	o.Action = v
}

// GetState returns state, or the zero value when it is absent.
func (o *Assumptions) GetState() (v map[string]Assumption) {
	if o != nil && o.State != nil {
		v = o.State
	}
	return v
}

// SetState sets state.
func (o *Assumptions) SetState(v map[string]Assumption) {
	o.State = v
}
