// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Comparison See scoring.md for every number here.
type Comparison struct {
	// Id of the run that the others are compared with.
	Baseline string `json:"baseline"`
	BenchmarkId string `json:"benchmark_id"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	Tolerance float64 `json:"tolerance"`
	// One entry per run that was named, in that order.
	Runs []ComparedRun `json:"runs"`
}
