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
	// Absent where `sealed_splits` of the benchmark names the split.
	Seed *int64 `json:"seed,omitzero"`
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
	Player *PlayerView `json:"player,omitzero"`
	// Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`.
	ClippedActions *int32 `json:"clipped_actions,omitzero"`
	// Sum of the rewards of the attempt, its return; for the profile `attribution`.
	TotalReward *float64 `json:"total_reward,omitzero"`
}

// GetSeed returns seed, or the zero value when it is absent.
func (o *EpisodeResult) GetSeed() (v int64) {
	if o != nil && o.Seed != nil {
		v = *o.Seed
	}
	return v
}

// SetSeed sets seed.
func (o *EpisodeResult) SetSeed(v int64) {
	o.Seed = &v
}

// GetPlayer returns player, or the zero value when it is absent.
func (o *EpisodeResult) GetPlayer() (v PlayerView) {
	if o != nil && o.Player != nil {
		v = *o.Player
	}
	return v
}

// SetPlayer sets player.
func (o *EpisodeResult) SetPlayer(v PlayerView) {
	o.Player = &v
}

// GetClippedActions returns clipped_actions, or the zero value when it is absent.
func (o *EpisodeResult) GetClippedActions() (v int32) {
	if o != nil && o.ClippedActions != nil {
		v = *o.ClippedActions
	}
	return v
}

// SetClippedActions sets clipped_actions.
func (o *EpisodeResult) SetClippedActions(v int32) {
	o.ClippedActions = &v
}

// GetTotalReward returns total_reward, or the zero value when it is absent.
func (o *EpisodeResult) GetTotalReward() (v float64) {
	if o != nil && o.TotalReward != nil {
		v = *o.TotalReward
	}
	return v
}

// SetTotalReward sets total_reward.
func (o *EpisodeResult) SetTotalReward(v float64) {
	o.TotalReward = &v
}
