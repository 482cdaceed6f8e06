// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// RankedEntry is a message of the protocol.
type RankedEntry struct {
	Entry BoardEntry `json:"entry"`
	Rank *RankInterval `json:"rank,omitzero"`
	// How many entries are significantly better; 0 without a rank.
	Better int32 `json:"better"`
	// How many entries are significantly worse; 0 without a rank.
	Worse int32 `json:"worse"`
	// Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank.
	Letters []string `json:"letters"`
}

// GetRank returns rank, or the zero value when it is absent.
func (o *RankedEntry) GetRank() (v RankInterval) {
	if o != nil && o.Rank != nil {
		v = *o.Rank
	}
	return v
}

// SetRank sets rank.
func (o *RankedEntry) SetRank(v RankInterval) {
	o.Rank = &v
}
