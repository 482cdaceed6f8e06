// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// SimulatorInfo is a message of the protocol.
type SimulatorInfo struct {
	Name string `json:"name"`
	Version string `json:"version"`
	// Named rendering quality, where there is one.
	Quality *string `json:"quality,omitzero"`
}

// GetQuality returns quality, or the zero value when it is absent.
func (o *SimulatorInfo) GetQuality() (v string) {
	if o != nil && o.Quality != nil {
		v = *o.Quality
	}
	return v
}

// SetQuality sets quality.
func (o *SimulatorInfo) SetQuality(v string) {
	o.Quality = &v
}
