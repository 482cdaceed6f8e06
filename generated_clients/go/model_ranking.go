// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Ranking See board.md for every number here.
type Ranking struct {
	BenchmarkId string `json:"benchmark_id"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	// How many episodes each entry has; null where the manifest has no entry.
	EpisodesTotal NullableInt32 `json:"episodes_total"`
	// How many entries have a rank.
	Ranked int32 `json:"ranked"`
	// How many pairs of them were tested.
	Comparisons int64 `json:"comparisons"`
	// How likely it is at most that any two equally good policies are distinguished; 0.05.
	Alpha float64 `json:"alpha"`
	// Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes.
	DifferingMin NullableInt32 `json:"differing_min"`
	// Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes.
	DifferingEnough NullableInt32 `json:"differing_enough"`
	Rows []RankedEntry `json:"rows"`
	NextCursor NullableString `json:"next_cursor" validate:"regexp=^[A-Za-z0-9_-]{1\\,128}$"`
}
