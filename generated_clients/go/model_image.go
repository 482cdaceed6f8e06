// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Image RGB or grey, row 0 on top; raw is height × width × channels bytes.
type Image struct {
	Codec string `json:"codec" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Width int32 `json:"width"`
	Height int32 `json:"height"`
	Channels int32 `json:"channels"`
	// Base64 with padding in JSON; `bin` in MessagePack.
	Data string `json:"data"`
}
