// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PolicyServerView The policy server of a run with mode `push`, with what was left open filled in, and without its key.
type PolicyServerView struct {
	Url string `json:"url"`
	// A `PolicyProtocol`, or one of a later version.
	Protocol string `json:"protocol" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	HasApiKey bool `json:"has_api_key"`
	Model *string `json:"model,omitzero"`
	CallTimeoutS float64 `json:"call_timeout_s"`
	MaxConcurrent int32 `json:"max_concurrent"`
	MaxRetries int32 `json:"max_retries"`
	Generation map[string]float64 `json:"generation,omitzero"`
}

// GetModel returns model, or the zero value when it is absent.
func (o *PolicyServerView) GetModel() (v string) {
	if o != nil && o.Model != nil {
		v = *o.Model
	}
	return v
}

// SetModel sets model.
func (o *PolicyServerView) SetModel(v string) {
	o.Model = &v
}

// GetGeneration returns generation, or the zero value when it is absent.
func (o *PolicyServerView) GetGeneration() (v map[string]float64) {
	if o != nil && o.Generation != nil {
		v = o.Generation
	}
	return v
}

// SetGeneration sets generation.
func (o *PolicyServerView) SetGeneration(v map[string]float64) {
	o.Generation = v
}
