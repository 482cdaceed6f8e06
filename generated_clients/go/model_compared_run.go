// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ComparedRun One run beside the baseline. A pair is an episode that both have scored.
type ComparedRun struct {
	RunId string `json:"run_id"`
	// Both runs have scored every episode.
	Complete bool `json:"complete"`
	// Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
	Release bool `json:"release"`
	// Number of pairs.
	Paired int32 `json:"paired"`
	// Mean score of the baseline over the pairs.
	BaselineMean NullableFloat64 `json:"baseline_mean"`
	// Mean score of the run over the pairs.
	Mean NullableFloat64 `json:"mean"`
	// Baseline minus run: positive when the run is worse.
	Difference NullableFloat64 `json:"difference"`
	// Pairs in which the run alone succeeds.
	Wins int32 `json:"wins"`
	// Pairs in which the baseline alone succeeds.
	Losses int32 `json:"losses"`
	// Pairs in which both succeed or neither does.
	Ties int32 `json:"ties"`
	// McNemar's exact test, two-sided.
	PValue float64 `json:"p_value"`
	// Task → the pairs of its episodes.
	ByTask map[string]ComparedTask `json:"by_task"`
}
