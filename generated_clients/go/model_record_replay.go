// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RecordReplay As in a verdict (record.md); absent before the end of the replay, and where there is none.
type RecordReplay struct {
	// `exact`, `outcome` or `diverged`.
	Result string `json:"result" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Episodes int32 `json:"episodes"`
	Exact int32 `json:"exact"`
	Outcome int32 `json:"outcome"`
	Diverged int32 `json:"diverged"`
	FirstDivergence *ReplayDivergence `json:"first_divergence,omitzero"`
}

// GetFirstDivergence returns first_divergence, or the zero value when it is absent.
func (o *RecordReplay) GetFirstDivergence() (v ReplayDivergence) {
	if o != nil && o.FirstDivergence != nil {
		v = *o.FirstDivergence
	}
	return v
}

// SetFirstDivergence sets first_divergence.
func (o *RecordReplay) SetFirstDivergence(v ReplayDivergence) {
	o.FirstDivergence = &v
}
