// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// StopRun is a message of the protocol.
type StopRun struct {
	Mode *StopMode `json:"mode,omitzero"`
}

// GetMode returns mode, or the zero value when it is absent.
func (o *StopRun) GetMode() (v StopMode) {
	if o != nil && o.Mode != nil {
		v = *o.Mode
	}
	return v
}

// SetMode sets mode.
func (o *StopRun) SetMode(v StopMode) {
	o.Mode = &v
}
