// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Benchmark Everything about a benchmark that can change a score.
type Benchmark struct {
	BenchmarkId string `json:"benchmark_id"`
	Version string `json:"version"`
	Title string `json:"title"`
	Description string `json:"description"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	EpisodesTotal int32 `json:"episodes_total"`
	Tasks []string `json:"tasks"`
	Splits []string `json:"splits"`
	// Splits whose seeds the host draws in secret; none when absent.
	SealedSplits []string `json:"sealed_splits,omitzero"`
	// What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played.
	SeedsSha256 *string `json:"seeds_sha256,omitzero" validate:"regexp=^[0-9a-f]{64}$"`
	// Actions per simulated second.
	ControlRateHz float64 `json:"control_rate_hz"`
	// Steps after which an episode is truncated.
	MaxSteps int32 `json:"max_steps"`
	MaxChunk int32 `json:"max_chunk"`
	MaxAttempts int32 `json:"max_attempts"`
	MaxFaults int32 `json:"max_faults"`
	// A `SuccessRule`, or one of a later version.
	SuccessRule string `json:"success_rule" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// Name of an action value → what it means.
	ActionSpace map[string]VectorSpace `json:"action_space"`
	ObservationSpace ObservationSpace `json:"observation_space"`
	// Sizes that may be chosen at submit; the first is the default.
	ImageSizes []ImageSize `json:"image_sizes"`
	// Codecs that may be chosen at submit; the first is the default.
	ImageCodecs []string `json:"image_codecs"`
	Simulator SimulatorInfo `json:"simulator"`
	// Why a run cannot be submitted here now, and the cure; null when it can.
	UnavailableReason NullableString `json:"unavailable_reason"`
}

// GetSealedSplits returns sealed_splits, or the zero value when it is absent.
func (o *Benchmark) GetSealedSplits() (v []string) {
	if o != nil && o.SealedSplits != nil {
		v = o.SealedSplits
	}
	return v
}

// SetSealedSplits sets sealed_splits.
func (o *Benchmark) SetSealedSplits(v []string) {
	o.SealedSplits = v
}

// GetSeedsSha256 returns seeds_sha256, or the zero value when it is absent.
func (o *Benchmark) GetSeedsSha256() (v string) {
	if o != nil && o.SeedsSha256 != nil {
		v = *o.SeedsSha256
	}
	return v
}

// SetSeedsSha256 sets seeds_sha256.
func (o *Benchmark) SetSeedsSha256(v string) {
	o.SeedsSha256 = &v
}
