// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// SelectionView The `select` of a run, as it was submitted.
type SelectionView struct {
	Tasks []string `json:"tasks,omitzero"`
	Splits []string `json:"splits,omitzero"`
}

// GetTasks returns tasks, or the zero value when it is absent.
func (o *SelectionView) GetTasks() (v []string) {
	if o != nil && o.Tasks != nil {
		v = o.Tasks
	}
	return v
}

// SetTasks sets tasks.
func (o *SelectionView) SetTasks(v []string) {
	o.Tasks = v
}

// GetSplits returns splits, or the zero value when it is absent.
func (o *SelectionView) GetSplits() (v []string) {
	if o != nil && o.Splits != nil {
		v = o.Splits
	}
	return v
}

// SetSplits sets splits.
func (o *SelectionView) SetSplits(v []string) {
	o.Splits = v
}
