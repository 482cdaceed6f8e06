// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Interval 95 % interval.
type Interval struct {
	Low float64 `json:"low"`
	High float64 `json:"high"`
}
