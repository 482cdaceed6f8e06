// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// EpisodeStatus is a list that later minor versions do not extend.
type EpisodeStatus string

const (
	EPISODESTATUS_PENDING EpisodeStatus = "pending"
	EPISODESTATUS_IN_PROGRESS EpisodeStatus = "in_progress"
	EPISODESTATUS_SCORED EpisodeStatus = "scored"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v EpisodeStatus) Ptr() *EpisodeStatus {
	return &v
}
