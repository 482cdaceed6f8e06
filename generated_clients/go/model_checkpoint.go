// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Checkpoint is a message of the protocol.
type Checkpoint struct {
	TreeSize int64 `json:"tree_size"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	RootSha256 string `json:"root_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	// The signed note, which says both as well.
	Note string `json:"note"`
	// Of the key of `list_keys` that signed it.
	Keyid string `json:"keyid"`
}
