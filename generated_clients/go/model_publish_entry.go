// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PublishEntry What an entry says of itself; a member that is absent is not shown.
type PublishEntry struct {
	ModelName string `json:"model_name"`
	// Whether others see the entry, and whether it has a rank.
	IsPublic bool `json:"is_public"`
	// What kind of model it is, for example `VLA` or `diffusion policy`.
	ModelType *string `json:"model_type,omitzero"`
	Organisation *string `json:"organisation,omitzero"`
	Homepage *string `json:"homepage,omitzero" validate:"regexp=^https?://[!-~]+$"`
	CodeUrl *string `json:"code_url,omitzero" validate:"regexp=^https?://[!-~]+$"`
	Notes *string `json:"notes,omitzero"`
}

// GetModelType returns model_type, or the zero value when it is absent.
func (o *PublishEntry) GetModelType() (v string) {
	if o != nil && o.ModelType != nil {
		v = *o.ModelType
	}
	return v
}

// SetModelType sets model_type.
func (o *PublishEntry) SetModelType(v string) {
	o.ModelType = &v
}

// GetOrganisation returns organisation, or the zero value when it is absent.
func (o *PublishEntry) GetOrganisation() (v string) {
	if o != nil && o.Organisation != nil {
		v = *o.Organisation
	}
	return v
}

// SetOrganisation sets organisation.
func (o *PublishEntry) SetOrganisation(v string) {
	o.Organisation = &v
}

// GetHomepage returns homepage, or the zero value when it is absent.
func (o *PublishEntry) GetHomepage() (v string) {
	if o != nil && o.Homepage != nil {
		v = *o.Homepage
	}
	return v
}

// SetHomepage sets homepage.
func (o *PublishEntry) SetHomepage(v string) {
	o.Homepage = &v
}

// GetCodeUrl returns code_url, or the zero value when it is absent.
func (o *PublishEntry) GetCodeUrl() (v string) {
	if o != nil && o.CodeUrl != nil {
		v = *o.CodeUrl
	}
	return v
}

// SetCodeUrl sets code_url.
func (o *PublishEntry) SetCodeUrl(v string) {
	o.CodeUrl = &v
}

// GetNotes returns notes, or the zero value when it is absent.
func (o *PublishEntry) GetNotes() (v string) {
	if o != nil && o.Notes != nil {
		v = *o.Notes
	}
	return v
}

// SetNotes sets notes.
func (o *PublishEntry) SetNotes(v string) {
	o.Notes = &v
}
