// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ImageChoice Recorded with the result, because it changes the score.
type ImageChoice struct {
	Codec string `json:"codec" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Width int32 `json:"width"`
	Height int32 `json:"height"`
}
