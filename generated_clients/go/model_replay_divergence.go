// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ReplayDivergence The first state that was another one; absent where every state was met.
type ReplayDivergence struct {
	EpisodeIndex int32 `json:"episode_index"`
	Attempt int64 `json:"attempt"`
	// After how many steps of the attempt the state was another one.
	Step int64 `json:"step"`
}
