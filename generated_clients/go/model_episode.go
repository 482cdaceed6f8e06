// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Episode is a message of the protocol.
type Episode struct {
	EpisodeId string `json:"episode_id"`
	Index int32 `json:"index"`
	Task string `json:"task"`
	Split string `json:"split"`
	Status EpisodeStatus `json:"status"`
	// The current or next attempt.
	Attempt int32 `json:"attempt"`
	Faults int32 `json:"faults"`
	// In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode.
	PolicyFault *string `json:"policy_fault,omitzero"`
	Result *EpisodeResult `json:"result,omitzero"`
}

// GetPolicyFault returns policy_fault, or the zero value when it is absent.
func (o *Episode) GetPolicyFault() (v string) {
	if o != nil && o.PolicyFault != nil {
		v = *o.PolicyFault
	}
	return v
}

// SetPolicyFault sets policy_fault.
func (o *Episode) SetPolicyFault(v string) {
	o.PolicyFault = &v
}

// GetResult returns result, or the zero value when it is absent.
func (o *Episode) GetResult() (v EpisodeResult) {
	if o != nil && o.Result != nil {
		v = *o.Result
	}
	return v
}

// SetResult sets result.
func (o *Episode) SetResult(v EpisodeResult) {
	o.Result = &v
}
