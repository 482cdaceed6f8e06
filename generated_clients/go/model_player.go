// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Player Who plays, by its own words; for the profile `attribution`.
type Player struct {
	// Of the policy, as in `policy` of the run.
	Name string `json:"name"`
	// Of the policy.
	Version *string `json:"version,omitzero"`
	// The program that attaches and its version.
	Client *string `json:"client,omitzero"`
}

// GetVersion returns version, or the zero value when it is absent.
func (o *Player) GetVersion() (v string) {
	if o != nil && o.Version != nil {
		v = *o.Version
	}
	return v
}

// SetVersion sets version.
func (o *Player) SetVersion(v string) {
	o.Version = &v
}

// GetClient returns client, or the zero value when it is absent.
func (o *Player) GetClient() (v string) {
	if o != nil && o.Client != nil {
		v = *o.Client
	}
	return v
}

// SetClient sets client.
func (o *Player) SetClient(v string) {
	o.Client = &v
}
