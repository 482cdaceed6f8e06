// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Score See scoring.md for every number here.
type Score struct {
	RunId string `json:"run_id"`
	BenchmarkId string `json:"benchmark_id"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	Select *SelectionView `json:"select,omitzero"`
	State RunState `json:"state"`
	Complete bool `json:"complete"`
	// Null until complete.
	Score NullableFloat64 `json:"score"`
	ScoreLow float64 `json:"score_low"`
	ScoreHigh float64 `json:"score_high"`
	Counts OutcomeCounts `json:"counts"`
	SuccessRate NullableFloat64 `json:"success_rate"`
	SuccessInterval Interval `json:"success_interval"`
	// Mean over the scored episodes.
	Mean NullableFloat64 `json:"mean"`
	MeanInterval Interval `json:"mean_interval"`
	ByTask map[string]GroupScore `json:"by_task"`
	BySplit map[string]GroupScore `json:"by_split"`
}

// GetSelect returns select, or the zero value when it is absent.
func (o *Score) GetSelect() (v SelectionView) {
	if o != nil && o.Select != nil {
		v = *o.Select
	}
	return v
}

// SetSelect sets select.
func (o *Score) SetSelect(v SelectionView) {
	o.Select = &v
}
