// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Predict is a message of the protocol.
type Predict struct {
	SessionId string `json:"session_id"`
	Seq int64 `json:"seq"`
	Actions []Action `json:"actions"`
	Observe *Observe `json:"observe,omitzero"`
}

// GetObserve returns observe, or the zero value when it is absent.
func (o *Predict) GetObserve() (v Observe) {
	if o != nil && o.Observe != nil {
		v = *o.Observe
	}
	return v
}

// SetObserve sets observe.
func (o *Predict) SetObserve(v Observe) {
	o.Observe = &v
}
