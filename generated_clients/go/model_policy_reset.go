// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PolicyReset The policy is ready for this attempt and no other.
type PolicyReset struct {
	SessionId string `json:"session_id"`
	EpisodeId string `json:"episode_id"`
	Attempt int32 `json:"attempt"`
}
