// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// AttachWorker is a message of the protocol.
type AttachWorker struct {
	// New for every attachment; repeated only to repeat a lost request.
	AttachKey string `json:"attach_key"`
	// Fence out a live session; false when absent.
	Takeover *bool `json:"takeover,omitzero"`
	Assumes *Assumptions `json:"assumes,omitzero"`
	Player *Player `json:"player,omitzero"`
}

// GetTakeover returns takeover, or the zero value when it is absent.
func (o *AttachWorker) GetTakeover() (v bool) {
	if o != nil && o.Takeover != nil {
		v = *o.Takeover
	}
	return v
}

// SetTakeover sets takeover.
func (o *AttachWorker) SetTakeover(v bool) {
	o.Takeover = &v
}

// GetAssumes returns assumes, or the zero value when it is absent.
func (o *AttachWorker) GetAssumes() (v Assumptions) {
	if o != nil && o.Assumes != nil {
		v = *o.Assumes
	}
	return v
}

// SetAssumes sets assumes.
func (o *AttachWorker) SetAssumes(v Assumptions) {
	o.Assumes = &v
}

// GetPlayer returns player, or the zero value when it is absent.
func (o *AttachWorker) GetPlayer() (v Player) {
	if o != nil && o.Player != nil {
		v = *o.Player
	}
	return v
}

// SetPlayer sets player.
func (o *AttachWorker) SetPlayer(v Player) {
	o.Player = &v
}
