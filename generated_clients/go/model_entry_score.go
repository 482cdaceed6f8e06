// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// EntryScore Of the `get_score` of the run.
type EntryScore struct {
	Score float64 `json:"score"`
	SuccessRate float64 `json:"success_rate"`
	SuccessInterval Interval `json:"success_interval"`
	MeanInterval Interval `json:"mean_interval"`
	Counts OutcomeCounts `json:"counts"`
}
