// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// BenchmarkList is a message of the protocol.
type BenchmarkList struct {
	Benchmarks []BenchmarkSummary `json:"benchmarks"`
}
