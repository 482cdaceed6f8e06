// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// CalibrationOptions Only for the benchmark `calibration`, which the submitter shapes.
type CalibrationOptions struct {
	// One entry per episode, in order; one `score` episode when absent.
	Tasks []CalibrationTask `json:"tasks,omitzero"`
	// 10 when absent.
	MaxSteps *int32 `json:"max_steps,omitzero"`
	SuccessRule *SuccessRule `json:"success_rule,omitzero"`
	// 3 when absent.
	MaxAttempts *int32 `json:"max_attempts,omitzero"`
	// 3 when absent.
	MaxFaults *int32 `json:"max_faults,omitzero"`
	// Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`.
	Sealed *bool `json:"sealed,omitzero"`
	// Seconds for which the run stays queued after submit and after resume; 0 when absent.
	QueueS *float64 `json:"queue_s,omitzero"`
}

// GetTasks returns tasks, or the zero value when it is absent.
func (o *CalibrationOptions) GetTasks() (v []CalibrationTask) {
	if o != nil && o.Tasks != nil {
		v = o.Tasks
	}
	return v
}

// SetTasks sets tasks.
func (o *CalibrationOptions) SetTasks(v []CalibrationTask) {
	o.Tasks = v
}

// GetMaxSteps returns max_steps, or the zero value when it is absent.
func (o *CalibrationOptions) GetMaxSteps() (v int32) {
	if o != nil && o.MaxSteps != nil {
		v = *o.MaxSteps
	}
	return v
}

// SetMaxSteps sets max_steps.
func (o *CalibrationOptions) SetMaxSteps(v int32) {
	o.MaxSteps = &v
}

// GetSuccessRule returns success_rule, or the zero value when it is absent.
func (o *CalibrationOptions) GetSuccessRule() (v SuccessRule) {
	if o != nil && o.SuccessRule != nil {
		v = *o.SuccessRule
	}
	return v
}

// SetSuccessRule sets success_rule.
func (o *CalibrationOptions) SetSuccessRule(v SuccessRule) {
	o.SuccessRule = &v
}

// GetMaxAttempts returns max_attempts, or the zero value when it is absent.
func (o *CalibrationOptions) GetMaxAttempts() (v int32) {
	if o != nil && o.MaxAttempts != nil {
		v = *o.MaxAttempts
	}
	return v
}

// SetMaxAttempts sets max_attempts.
func (o *CalibrationOptions) SetMaxAttempts(v int32) {
	o.MaxAttempts = &v
}

// GetMaxFaults returns max_faults, or the zero value when it is absent.
func (o *CalibrationOptions) GetMaxFaults() (v int32) {
	if o != nil && o.MaxFaults != nil {
		v = *o.MaxFaults
	}
	return v
}

// SetMaxFaults sets max_faults.
func (o *CalibrationOptions) SetMaxFaults(v int32) {
	o.MaxFaults = &v
}

// GetSealed returns sealed, or the zero value when it is absent.
func (o *CalibrationOptions) GetSealed() (v bool) {
	if o != nil && o.Sealed != nil {
		v = *o.Sealed
	}
	return v
}

// SetSealed sets sealed.
func (o *CalibrationOptions) SetSealed(v bool) {
	o.Sealed = &v
}

// GetQueueS returns queue_s, or the zero value when it is absent.
func (o *CalibrationOptions) GetQueueS() (v float64) {
	if o != nil && o.QueueS != nil {
		v = *o.QueueS
	}
	return v
}

// SetQueueS sets queue_s.
func (o *CalibrationOptions) SetQueueS(v float64) {
	o.QueueS = &v
}
