// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PolicyServer Where the server finds the policy of a run with mode `push`, and how it calls it.
type PolicyServer struct {
	// Base URL, without user, query or fragment; the path of an operation is appended to it.
	Url string `json:"url" validate:"regexp=^https?://[A-Za-z0-9.:_\\[\\]-]+(/[A-Za-z0-9._~%/-]*)?$"`
	Protocol PolicyProtocol `json:"protocol"`
	// Sent as bearer token with every call, and never shown.
	ApiKey *string `json:"api_key,omitzero" validate:"regexp=^[!-~]+$"`
	// Which model is asked, where a protocol knows several.
	Model *string `json:"model,omitzero"`
	// Time for one call, from connecting to the last byte of its answer; 30 when absent.
	CallTimeoutS *float64 `json:"call_timeout_s,omitzero"`
	// Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
	MaxConcurrent *int32 `json:"max_concurrent,omitzero"`
	// How often a call that was not answered is repeated; 3 when absent.
	MaxRetries *int32 `json:"max_retries,omitzero"`
	// Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone.
	Generation map[string]float64 `json:"generation,omitzero"`
}

// GetApiKey returns api_key, or the zero value when it is absent.
func (o *PolicyServer) GetApiKey() (v string) {
	if o != nil && o.ApiKey != nil {
		v = *o.ApiKey
	}
	return v
}

// SetApiKey sets api_key.
func (o *PolicyServer) SetApiKey(v string) {
	o.ApiKey = &v
}

// GetModel returns model, or the zero value when it is absent.
func (o *PolicyServer) GetModel() (v string) {
	if o != nil && o.Model != nil {
		v = *o.Model
	}
	return v
}

// SetModel sets model.
func (o *PolicyServer) SetModel(v string) {
	o.Model = &v
}

// GetCallTimeoutS returns call_timeout_s, or the zero value when it is absent.
func (o *PolicyServer) GetCallTimeoutS() (v float64) {
	if o != nil && o.CallTimeoutS != nil {
		v = *o.CallTimeoutS
	}
	return v
}

// SetCallTimeoutS sets call_timeout_s.
func (o *PolicyServer) SetCallTimeoutS(v float64) {
	o.CallTimeoutS = &v
}

// GetMaxConcurrent returns max_concurrent, or the zero value when it is absent.
func (o *PolicyServer) GetMaxConcurrent() (v int32) {
	if o != nil && o.MaxConcurrent != nil {
		v = *o.MaxConcurrent
	}
	return v
}

// SetMaxConcurrent sets max_concurrent.
func (o *PolicyServer) SetMaxConcurrent(v int32) {
	o.MaxConcurrent = &v
}

// GetMaxRetries returns max_retries, or the zero value when it is absent.
func (o *PolicyServer) GetMaxRetries() (v int32) {
	if o != nil && o.MaxRetries != nil {
		v = *o.MaxRetries
	}
	return v
}

// SetMaxRetries sets max_retries.
func (o *PolicyServer) SetMaxRetries(v int32) {
	o.MaxRetries = &v
}

// GetGeneration returns generation, or the zero value when it is absent.
func (o *PolicyServer) GetGeneration() (v map[string]float64) {
	if o != nil && o.Generation != nil {
		v = o.Generation
	}
	return v
}

// SetGeneration sets generation.
func (o *PolicyServer) SetGeneration(v map[string]float64) {
	o.Generation = v
}
