// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PolicyDescription What a policy server says of itself; see policy.yaml.
type PolicyDescription struct {
	Name string `json:"name"`
	Version *string `json:"version,omitzero"`
	Protocol ProtocolRange `json:"protocol"`
	// Most episodes that it plays at a time.
	MaxSessions int32 `json:"max_sessions"`
	Assumes *Assumptions `json:"assumes,omitzero"`
}

// GetVersion returns version, or the zero value when it is absent.
func (o *PolicyDescription) GetVersion() (v string) {
	if o != nil && o.Version != nil {
		v = *o.Version
	}
	return v
}

// SetVersion sets version.
func (o *PolicyDescription) SetVersion(v string) {
	o.Version = &v
}

// GetAssumes returns assumes, or the zero value when it is absent.
func (o *PolicyDescription) GetAssumes() (v Assumptions) {
	if o != nil && o.Assumes != nil {
		v = *o.Assumes
	}
	return v
}

// SetAssumes sets assumes.
func (o *PolicyDescription) SetAssumes(v Assumptions) {
	o.Assumes = &v
}
