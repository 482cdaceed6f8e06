// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Fault The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one.
type Fault struct {
	EpisodeId string `json:"episode_id"`
	// Faults of this episode so far.
	Faults int32 `json:"faults"`
	Detail string `json:"detail"`
}
