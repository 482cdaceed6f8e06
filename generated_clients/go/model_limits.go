// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Limits is a message of the protocol.
type Limits struct {
	// Longest request body that is read.
	MaxBodyBytes int64 `json:"max_body_bytes"`
	// Most live workers a run may ask for.
	MaxWorkers int32 `json:"max_workers"`
	// Most actions in one predict; a benchmark may allow fewer.
	MaxChunk int32 `json:"max_chunk"`
	IdleTimeoutSMin float64 `json:"idle_timeout_s_min"`
	IdleTimeoutSMax float64 `json:"idle_timeout_s_max"`
	// Longest wait that a long-poll is granted.
	WaitSMax int32 `json:"wait_s_max"`
	// Longest request line with its headers that is read; for the profile `limits`.
	MaxHeaderBytes *int32 `json:"max_header_bytes,omitzero"`
	// Time in which the headers of a request are complete, from its first byte; for the profile `limits`.
	HeaderTimeoutS *float64 `json:"header_timeout_s,omitzero"`
	// Time in which a part of a body arrives after the headers of its request; for the profile `limits`.
	BodyTimeoutS *float64 `json:"body_timeout_s,omitzero"`
}

// GetMaxHeaderBytes returns max_header_bytes, or the zero value when it is absent.
func (o *Limits) GetMaxHeaderBytes() (v int32) {
	if o != nil && o.MaxHeaderBytes != nil {
		v = *o.MaxHeaderBytes
	}
	return v
}

// SetMaxHeaderBytes sets max_header_bytes.
func (o *Limits) SetMaxHeaderBytes(v int32) {
	o.MaxHeaderBytes = &v
}

// GetHeaderTimeoutS returns header_timeout_s, or the zero value when it is absent.
func (o *Limits) GetHeaderTimeoutS() (v float64) {
	if o != nil && o.HeaderTimeoutS != nil {
		v = *o.HeaderTimeoutS
	}
	return v
}

// SetHeaderTimeoutS sets header_timeout_s.
func (o *Limits) SetHeaderTimeoutS(v float64) {
	o.HeaderTimeoutS = &v
}

// GetBodyTimeoutS returns body_timeout_s, or the zero value when it is absent.
func (o *Limits) GetBodyTimeoutS() (v float64) {
	if o != nil && o.BodyTimeoutS != nil {
		v = *o.BodyTimeoutS
	}
	return v
}

// SetBodyTimeoutS sets body_timeout_s.
func (o *Limits) SetBodyTimeoutS(v float64) {
	o.BodyTimeoutS = &v
}
