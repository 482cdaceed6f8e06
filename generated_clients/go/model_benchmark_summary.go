// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// BenchmarkSummary is a message of the protocol.
type BenchmarkSummary struct {
	BenchmarkId string `json:"benchmark_id"`
	Version string `json:"version"`
	Title string `json:"title"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	EpisodesTotal int32 `json:"episodes_total"`
}
