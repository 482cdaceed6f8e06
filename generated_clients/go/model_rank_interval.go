// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RankInterval The ranks that an entry may have; absent for an entry that is flagged.
type RankInterval struct {
	// The best one.
	Low int32 `json:"low"`
	// The worst one.
	High int32 `json:"high"`
}
