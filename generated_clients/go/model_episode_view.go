// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// EpisodeView The episode that the observation belongs to.
type EpisodeView struct {
	EpisodeId string `json:"episode_id"`
	// Position in the manifest.
	Index int32 `json:"index"`
	Task string `json:"task"`
	Instruction string `json:"instruction"`
	Attempt int32 `json:"attempt"`
	Step int32 `json:"step"`
	MaxSteps int32 `json:"max_steps"`
}
