// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Timing Server time of this turn, in seconds.
type Timing struct {
	TotalS float64 `json:"total_s"`
	QueueS float64 `json:"queue_s"`
	SimulateS float64 `json:"simulate_s"`
	RenderS float64 `json:"render_s"`
	// Encoding of images.
	EncodeS float64 `json:"encode_s"`
}
