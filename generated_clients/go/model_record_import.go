// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// RecordImport A record that was handed in, and what is known of it here.
type RecordImport struct {
	ImportId string `json:"import_id" validate:"regexp=^[A-Za-z0-9_-]{1\\,64}$"`
	// `waiting` for simulators, `replaying`, or `finished`.
	State string `json:"state" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// `reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise.
	Level string `json:"level" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// The level with who says it, as REC-031 has it.
	LevelText string `json:"level_text"`
	// Whose key signed the record, as this server knows it; null for a key that it does not know.
	Signer NullableString `json:"signer"`
	// Of the key that signed the record.
	Keyid string `json:"keyid"`
	ArchiveSha256 string `json:"archive_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	StatementSha256 string `json:"statement_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	SizeBytes int64 `json:"size_bytes"`
	// In the statement, as are the members below it.
	RunId string `json:"run_id"`
	BenchmarkId string `json:"benchmark_id"`
	BenchmarkVersion string `json:"benchmark_version"`
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	Policy ImportedPolicy `json:"policy"`
	// Null where an episode has no result.
	Score NullableFloat64 `json:"score"`
	Episodes int32 `json:"episodes"`
	// How many of them were simulated so far.
	EpisodesReplayed int32 `json:"episodes_replayed"`
	Replay *RecordReplay `json:"replay,omitzero"`
	// Why there is no replay.
	Reason NullableString `json:"reason"`
	ImportedAt time.Time `json:"imported_at"`
	FinishedAt NullableTime `json:"finished_at"`
}

// GetReplay returns replay, or the zero value when it is absent.
func (o *RecordImport) GetReplay() (v RecordReplay) {
	if o != nil && o.Replay != nil {
		v = *o.Replay
	}
	return v
}

// SetReplay sets replay.
func (o *RecordImport) SetReplay(v RecordReplay) {
	o.Replay = &v
}
