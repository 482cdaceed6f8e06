// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Assumption is a message of the protocol.
type Assumption struct {
	Size *int32 `json:"size,omitzero"`
	Unit *string `json:"unit,omitzero"`
	Rotation *string `json:"rotation,omitzero" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Frame *string `json:"frame,omitzero"`
	Relative *bool `json:"relative,omitzero"`
	GripperOpen *float64 `json:"gripper_open,omitzero"`
}

// GetSize returns size, or the zero value when it is absent.
func (o *Assumption) GetSize() (v int32) {
	if o != nil && o.Size != nil {
		v = *o.Size
	}
	return v
}

// SetSize sets size.
func (o *Assumption) SetSize(v int32) {
	o.Size = &v
}

// GetUnit returns unit, or the zero value when it is absent.
func (o *Assumption) GetUnit() (v string) {
	if o != nil && o.Unit != nil {
		v = *o.Unit
	}
	return v
}

// SetUnit sets unit.
func (o *Assumption) SetUnit(v string) {
	o.Unit = &v
}

// GetRotation returns rotation, or the zero value when it is absent.
func (o *Assumption) GetRotation() (v string) {
	if o != nil && o.Rotation != nil {
		v = *o.Rotation
	}
	return v
}

// SetRotation sets rotation.
func (o *Assumption) SetRotation(v string) {
	o.Rotation = &v
}

// GetFrame returns frame, or the zero value when it is absent.
func (o *Assumption) GetFrame() (v string) {
	if o != nil && o.Frame != nil {
		v = *o.Frame
	}
	return v
}

// SetFrame sets frame.
func (o *Assumption) SetFrame(v string) {
	o.Frame = &v
}

// GetRelative returns relative, or the zero value when it is absent.
func (o *Assumption) GetRelative() (v bool) {
	if o != nil && o.Relative != nil {
		v = *o.Relative
	}
	return v
}

// SetRelative sets relative.
func (o *Assumption) SetRelative(v bool) {
	o.Relative = &v
}

// GetGripperOpen returns gripper_open, or the zero value when it is absent.
func (o *Assumption) GetGripperOpen() (v float64) {
	if o != nil && o.GripperOpen != nil {
		v = *o.GripperOpen
	}
	return v
}

// SetGripperOpen sets gripper_open.
func (o *Assumption) SetGripperOpen(v float64) {
	o.GripperOpen = &v
}
