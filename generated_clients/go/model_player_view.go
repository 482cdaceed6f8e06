// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PlayerView The `player` of an `attach_worker`.
type PlayerView struct {
	Name string `json:"name"`
	Version *string `json:"version,omitzero"`
	Client *string `json:"client,omitzero"`
}

// GetVersion returns version, or the zero value when it is absent.
func (o *PlayerView) GetVersion() (v string) {
	if o != nil && o.Version != nil {
		v = *o.Version
	}
	return v
}

// SetVersion sets version.
func (o *PlayerView) SetVersion(v string) {
	o.Version = &v
}

// GetClient returns client, or the zero value when it is absent.
func (o *PlayerView) GetClient() (v string) {
	if o != nil && o.Client != nil {
		v = *o.Client
	}
	return v
}

// SetClient sets client.
func (o *PlayerView) SetClient(v string) {
	o.Client = &v
}
