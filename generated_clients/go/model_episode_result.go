// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// EpisodeResult is a message of the protocol.
type EpisodeResult struct {
	EpisodeId string `json:"episode_id"`
	Index int32 `json:"index"`
	Task string `json:"task"`
	Split string `json:"split"`
	Seed int64 `json:"seed"`
	Attempt int32 `json:"attempt"`
	Faults int32 `json:"faults"`
	Outcome Outcome `json:"outcome"`
	Score float64 `json:"score"`
	Steps int32 `json:"steps"`
	Terminated bool `json:"terminated"`
	Truncated bool `json:"truncated"`
	// Time between turns that the policy took.
	ThinkS float64 `json:"think_s"`
	FinishedAt time.Time `json:"finished_at"`
}
