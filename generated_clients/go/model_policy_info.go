// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PolicyInfo is a message of the protocol.
type PolicyInfo struct {
	Name string `json:"name"`
	Version *string `json:"version,omitzero"`
	Submitter *string `json:"submitter,omitzero"`
	Homepage *string `json:"homepage,omitzero"`
}

// GetVersion returns version, or the zero value when it is absent.
func (o *PolicyInfo) GetVersion() (v string) {
	if o != nil && o.Version != nil {
		v = *o.Version
	}
	return v
}

// SetVersion sets version.
func (o *PolicyInfo) SetVersion(v string) {
	o.Version = &v
}

// GetSubmitter returns submitter, or the zero value when it is absent.
func (o *PolicyInfo) GetSubmitter() (v string) {
	if o != nil && o.Submitter != nil {
		v = *o.Submitter
	}
	return v
}

// SetSubmitter sets submitter.
func (o *PolicyInfo) SetSubmitter(v string) {
	o.Submitter = &v
}

// GetHomepage returns homepage, or the zero value when it is absent.
func (o *PolicyInfo) GetHomepage() (v string) {
	if o != nil && o.Homepage != nil {
		v = *o.Homepage
	}
	return v
}

// SetHomepage sets homepage.
func (o *PolicyInfo) SetHomepage(v string) {
	o.Homepage = &v
}
