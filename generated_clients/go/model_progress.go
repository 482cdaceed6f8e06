// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Progress is a message of the protocol.
type Progress struct {
	EpisodesTotal int32 `json:"episodes_total"`
	// Abandoned ones included.
	EpisodesScored int32 `json:"episodes_scored"`
	EpisodesInProgress int32 `json:"episodes_in_progress"`
	EpisodesPending int32 `json:"episodes_pending"`
}
