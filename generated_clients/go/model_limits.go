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
}
