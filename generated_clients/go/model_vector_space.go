// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// VectorSpace One named vector of numbers, with every convention a policy could get wrong.
type VectorSpace struct {
	Size int32 `json:"size"`
	// `rad`, `m`, `1`, or several joined by commas.
	Unit string `json:"unit"`
	Rotation string `json:"rotation" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// `world`, `base`, `tool`, `joint`, or `none`.
	Frame string `json:"frame"`
	// True when the values are increments.
	Relative bool `json:"relative"`
	// The value that means fully open.
	GripperOpen *float64 `json:"gripper_open,omitzero"`
	Minimum []float64 `json:"minimum,omitzero"`
	Maximum []float64 `json:"maximum,omitzero"`
	OutOfRange string `json:"out_of_range" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// What the numbers are.
	Description *string `json:"description,omitzero"`
	// The tasks that have this entry; all of them when absent.
	Tasks []string `json:"tasks,omitzero"`
}

// GetGripperOpen returns gripper_open, or the zero value when it is absent.
func (o *VectorSpace) GetGripperOpen() (v float64) {
	if o != nil && o.GripperOpen != nil {
		v = *o.GripperOpen
	}
	return v
}

// SetGripperOpen sets gripper_open.
func (o *VectorSpace) SetGripperOpen(v float64) {
	o.GripperOpen = &v
}

// GetMinimum returns minimum, or the zero value when it is absent.
func (o *VectorSpace) GetMinimum() (v []float64) {
	if o != nil && o.Minimum != nil {
		v = o.Minimum
	}
	return v
}

// SetMinimum sets minimum.
func (o *VectorSpace) SetMinimum(v []float64) {
	o.Minimum = v
}

// GetMaximum returns maximum, or the zero value when it is absent.
func (o *VectorSpace) GetMaximum() (v []float64) {
	if o != nil && o.Maximum != nil {
		v = o.Maximum
	}
	return v
}

// SetMaximum sets maximum.
func (o *VectorSpace) SetMaximum(v []float64) {
	o.Maximum = v
}

// GetDescription returns description, or the zero value when it is absent.
func (o *VectorSpace) GetDescription() (v string) {
	if o != nil && o.Description != nil {
		v = *o.Description
	}
	return v
}

// SetDescription sets description.
func (o *VectorSpace) SetDescription(v string) {
	o.Description = &v
}

// GetTasks returns tasks, or the zero value when it is absent.
func (o *VectorSpace) GetTasks() (v []string) {
	if o != nil && o.Tasks != nil {
		v = o.Tasks
	}
	return v
}

// SetTasks sets tasks.
func (o *VectorSpace) SetTasks(v []string) {
	o.Tasks = v
}
