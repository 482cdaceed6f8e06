// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Turn The answer to attach (seq 0) and to predict.
type Turn struct {
	SessionId string `json:"session_id"`
	Seq int64 `json:"seq"`
	Episode *EpisodeView `json:"episode,omitzero"`
	Observation *Observation `json:"observation,omitzero"`
	// With `observe` all, one per executed action.
	Observations []Observation `json:"observations,omitzero"`
	ExecutedSteps int32 `json:"executed_steps"`
	// The episode ended before the chunk did.
	StoppedEarly bool `json:"stopped_early"`
	// One per executed action.
	Rewards []float64 `json:"rewards"`
	// The task ended by itself in this turn.
	Terminated bool `json:"terminated"`
	// The step limit ended the episode in this turn.
	Truncated bool `json:"truncated"`
	EpisodeResult *EpisodeResult `json:"episode_result,omitzero"`
	Fault *Fault `json:"fault,omitzero"`
	// No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
	Done bool `json:"done"`
	Lease Lease `json:"lease"`
	Timing Timing `json:"timing"`
}

// GetEpisode returns episode, or the zero value when it is absent.
func (o *Turn) GetEpisode() (v EpisodeView) {
	if o != nil && o.Episode != nil {
		v = *o.Episode
	}
	return v
}

// SetEpisode sets episode.
func (o *Turn) SetEpisode(v EpisodeView) {
	o.Episode = &v
}

// GetObservation returns observation, or the zero value when it is absent.
func (o *Turn) GetObservation() (v Observation) {
	if o != nil && o.Observation != nil {
		v = *o.Observation
	}
	return v
}

// SetObservation sets observation.
func (o *Turn) SetObservation(v Observation) {
	o.Observation = &v
}

// GetObservations returns observations, or the zero value when it is absent.
func (o *Turn) GetObservations() (v []Observation) {
	if o != nil && o.Observations != nil {
		v = o.Observations
	}
	return v
}

// SetObservations sets observations.
func (o *Turn) SetObservations(v []Observation) {
	o.Observations = v
}

// GetEpisodeResult returns episode_result, or the zero value when it is absent.
func (o *Turn) GetEpisodeResult() (v EpisodeResult) {
	if o != nil && o.EpisodeResult != nil {
		v = *o.EpisodeResult
	}
	return v
}

// SetEpisodeResult sets episode_result.
func (o *Turn) SetEpisodeResult(v EpisodeResult) {
	o.EpisodeResult = &v
}

// GetFault returns fault, or the zero value when it is absent.
func (o *Turn) GetFault() (v Fault) {
	if o != nil && o.Fault != nil {
		v = *o.Fault
	}
	return v
}

// SetFault sets fault.
func (o *Turn) SetFault(v Fault) {
	o.Fault = &v
}
