// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// BoardEntry is a message of the protocol.
type BoardEntry struct {
	EntryId string `json:"entry_id"`
	RunId string `json:"run_id"`
	// Name of the account that submitted the run.
	Submitter string `json:"submitter"`
	BenchmarkId string `json:"benchmark_id"`
	BenchmarkVersion string `json:"benchmark_version"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	Select *SelectionView `json:"select,omitzero"`
	Policy PolicyInfo `json:"policy"`
	ModelName string `json:"model_name"`
	IsPublic bool `json:"is_public"`
	ModelType *string `json:"model_type,omitzero"`
	Organisation *string `json:"organisation,omitzero"`
	Homepage *string `json:"homepage,omitzero"`
	CodeUrl *string `json:"code_url,omitzero"`
	Notes *string `json:"notes,omitzero"`
	State string `json:"state" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Flag *EntryFlag `json:"flag,omitzero"`
	// What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs.
	Level string `json:"level" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// How many runs of the benchmark the account has submitted until now, published or not.
	Attempts int32 `json:"attempts"`
	Score EntryScore `json:"score"`
	PublishedAt time.Time `json:"published_at"`
	// When the description, the state or the flag changed for the last time.
	ChangedAt time.Time `json:"changed_at"`
}

// GetSelect returns select, or the zero value when it is absent.
func (o *BoardEntry) GetSelect() (v SelectionView) {
	if o != nil && o.Select != nil {
		v = *o.Select
	}
	return v
}

// SetSelect sets select.
func (o *BoardEntry) SetSelect(v SelectionView) {
	o.Select = &v
}

// GetModelType returns model_type, or the zero value when it is absent.
func (o *BoardEntry) GetModelType() (v string) {
	if o != nil && o.ModelType != nil {
		v = *o.ModelType
	}
	return v
}

// SetModelType sets model_type.
func (o *BoardEntry) SetModelType(v string) {
	o.ModelType = &v
}

// GetOrganisation returns organisation, or the zero value when it is absent.
func (o *BoardEntry) GetOrganisation() (v string) {
	if o != nil && o.Organisation != nil {
		v = *o.Organisation
	}
	return v
}

// SetOrganisation sets organisation.
func (o *BoardEntry) SetOrganisation(v string) {
	o.Organisation = &v
}

// GetHomepage returns homepage, or the zero value when it is absent.
func (o *BoardEntry) GetHomepage() (v string) {
	if o != nil && o.Homepage != nil {
		v = *o.Homepage
	}
	return v
}

// SetHomepage sets homepage.
func (o *BoardEntry) SetHomepage(v string) {
	o.Homepage = &v
}

// GetCodeUrl returns code_url, or the zero value when it is absent.
func (o *BoardEntry) GetCodeUrl() (v string) {
	if o != nil && o.CodeUrl != nil {
		v = *o.CodeUrl
	}
	return v
}

// SetCodeUrl sets code_url.
func (o *BoardEntry) SetCodeUrl(v string) {
	o.CodeUrl = &v
}

// GetNotes returns notes, or the zero value when it is absent.
func (o *BoardEntry) GetNotes() (v string) {
	if o != nil && o.Notes != nil {
		v = *o.Notes
	}
	return v
}

// SetNotes sets notes.
func (o *BoardEntry) SetNotes(v string) {
	o.Notes = &v
}

// GetFlag returns flag, or the zero value when it is absent.
func (o *BoardEntry) GetFlag() (v EntryFlag) {
	if o != nil && o.Flag != nil {
		v = *o.Flag
	}
	return v
}

// SetFlag sets flag.
func (o *BoardEntry) SetFlag(v EntryFlag) {
	o.Flag = &v
}
