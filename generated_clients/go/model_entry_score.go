// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// EntryScore Of the `get_score` of the run.
type EntryScore struct {
	Score float64 `json:"score"`
	SuccessRate float64 `json:"success_rate"`
	SuccessInterval Interval `json:"success_interval"`
	MeanInterval Interval `json:"mean_interval"`
	Counts OutcomeCounts `json:"counts"`
	// Absent where the server does not show it, such as for many tasks.
	ByTask map[string]GroupScore `json:"by_task,omitzero"`
	// Absent where the server does not show it, such as for many splits.
	BySplit map[string]GroupScore `json:"by_split,omitzero"`
}

// GetByTask returns by_task, or the zero value when it is absent.
func (o *EntryScore) GetByTask() (v map[string]GroupScore) {
	if o != nil && o.ByTask != nil {
		v = o.ByTask
	}
	return v
}

// SetByTask sets by_task.
func (o *EntryScore) SetByTask(v map[string]GroupScore) {
	o.ByTask = v
}

// GetBySplit returns by_split, or the zero value when it is absent.
func (o *EntryScore) GetBySplit() (v map[string]GroupScore) {
	if o != nil && o.BySplit != nil {
		v = o.BySplit
	}
	return v
}

// SetBySplit sets by_split.
func (o *EntryScore) SetBySplit(v map[string]GroupScore) {
	o.BySplit = v
}
