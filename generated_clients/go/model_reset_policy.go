// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ResetPolicy An attempt begins; whatever the policy remembers of this session is over.
type ResetPolicy struct {
	SessionId string `json:"session_id"`
	RunId *string `json:"run_id,omitzero"`
	Benchmark Benchmark `json:"benchmark"`
	Episode EpisodeView `json:"episode"`
}

// GetRunId returns run_id, or the zero value when it is absent.
func (o *ResetPolicy) GetRunId() (v string) {
	if o != nil && o.RunId != nil {
		v = *o.RunId
	}
	return v
}

// SetRunId sets run_id.
func (o *ResetPolicy) SetRunId(v string) {
	o.RunId = &v
}
