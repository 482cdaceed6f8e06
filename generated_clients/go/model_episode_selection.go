// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// EpisodeSelection The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`.
type EpisodeSelection struct {
	Tasks []string `json:"tasks,omitzero"`
	Splits []string `json:"splits,omitzero"`
}

// GetTasks returns tasks, or the zero value when it is absent.
func (o *EpisodeSelection) GetTasks() (v []string) {
	if o != nil && o.Tasks != nil {
		v = o.Tasks
	}
	return v
}

// SetTasks sets tasks.
func (o *EpisodeSelection) SetTasks(v []string) {
	o.Tasks = v
}

// GetSplits returns splits, or the zero value when it is absent.
func (o *EpisodeSelection) GetSplits() (v []string) {
	if o != nil && o.Splits != nil {
		v = o.Splits
	}
	return v
}

// SetSplits sets splits.
func (o *EpisodeSelection) SetSplits(v []string) {
	o.Splits = v
}
