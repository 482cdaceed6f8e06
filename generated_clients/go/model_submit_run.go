// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// SubmitRun is a message of the protocol.
type SubmitRun struct {
	BenchmarkId string `json:"benchmark_id" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Policy PolicyInfo `json:"policy"`
	// Most live workers wanted; the server's limit when absent.
	MaxWorkers *int32 `json:"max_workers,omitzero"`
	// Lease of a session; the server's maximum when absent.
	IdleTimeoutS *float64 `json:"idle_timeout_s,omitzero"`
	Images *ImageChoice `json:"images,omitzero"`
	Options *CalibrationOptions `json:"options,omitzero"`
	Mode *RunMode `json:"mode,omitzero"`
	PolicyServer *PolicyServer `json:"policy_server,omitzero"`
	// Workers may play for another policy than `policy`; false when absent; for the profile `attribution`.
	AnyPolicy *bool `json:"any_policy,omitzero"`
	Select *EpisodeSelection `json:"select,omitzero"`
}

// GetMaxWorkers returns max_workers, or the zero value when it is absent.
func (o *SubmitRun) GetMaxWorkers() (v int32) {
	if o != nil && o.MaxWorkers != nil {
		v = *o.MaxWorkers
	}
	return v
}

// SetMaxWorkers sets max_workers.
func (o *SubmitRun) SetMaxWorkers(v int32) {
	o.MaxWorkers = &v
}

// GetIdleTimeoutS returns idle_timeout_s, or the zero value when it is absent.
func (o *SubmitRun) GetIdleTimeoutS() (v float64) {
	if o != nil && o.IdleTimeoutS != nil {
		v = *o.IdleTimeoutS
	}
	return v
}

// SetIdleTimeoutS sets idle_timeout_s.
func (o *SubmitRun) SetIdleTimeoutS(v float64) {
	o.IdleTimeoutS = &v
}

// GetImages returns images, or the zero value when it is absent.
func (o *SubmitRun) GetImages() (v ImageChoice) {
	if o != nil && o.Images != nil {
		v = *o.Images
	}
	return v
}

// SetImages sets images.
func (o *SubmitRun) SetImages(v ImageChoice) {
	o.Images = &v
}

// GetOptions returns options, or the zero value when it is absent.
func (o *SubmitRun) GetOptions() (v CalibrationOptions) {
	if o != nil && o.Options != nil {
		v = *o.Options
	}
	return v
}

// SetOptions sets options.
func (o *SubmitRun) SetOptions(v CalibrationOptions) {
	o.Options = &v
}

// GetMode returns mode, or the zero value when it is absent.
func (o *SubmitRun) GetMode() (v RunMode) {
	if o != nil && o.Mode != nil {
		v = *o.Mode
	}
	return v
}

// SetMode sets mode.
func (o *SubmitRun) SetMode(v RunMode) {
	o.Mode = &v
}

// GetPolicyServer returns policy_server, or the zero value when it is absent.
func (o *SubmitRun) GetPolicyServer() (v PolicyServer) {
	if o != nil && o.PolicyServer != nil {
		v = *o.PolicyServer
	}
	return v
}

// SetPolicyServer sets policy_server.
func (o *SubmitRun) SetPolicyServer(v PolicyServer) {
	o.PolicyServer = &v
}

// GetAnyPolicy returns any_policy, or the zero value when it is absent.
func (o *SubmitRun) GetAnyPolicy() (v bool) {
	if o != nil && o.AnyPolicy != nil {
		v = *o.AnyPolicy
	}
	return v
}

// SetAnyPolicy sets any_policy.
func (o *SubmitRun) SetAnyPolicy(v bool) {
	o.AnyPolicy = &v
}

// GetSelect returns select, or the zero value when it is absent.
func (o *SubmitRun) GetSelect() (v EpisodeSelection) {
	if o != nil && o.Select != nil {
		v = *o.Select
	}
	return v
}

// SetSelect sets select.
func (o *SubmitRun) SetSelect(v EpisodeSelection) {
	o.Select = &v
}
