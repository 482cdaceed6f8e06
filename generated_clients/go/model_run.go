// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"time"
)

// Run is a message of the protocol.
type Run struct {
	RunId string `json:"run_id"`
	State RunState `json:"state"`
	// Why the run is in this state, for people; never null when failed.
	Reason NullableString `json:"reason"`
	// Whether a failed run may be resumed; null in other states.
	Retryable NullableBool `json:"retryable"`
	BenchmarkId string `json:"benchmark_id"`
	BenchmarkVersion string `json:"benchmark_version"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	Policy PolicyInfo `json:"policy"`
	// A `RunMode`, or one of a later version; `pull` when absent.
	Mode *string `json:"mode,omitzero" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	PolicyServer *PolicyServerView `json:"policy_server,omitzero"`
	// Whether workers may play for another policy than `policy`; for the profile `attribution`.
	AnyPolicy *bool `json:"any_policy,omitzero"`
	Select *SelectionView `json:"select,omitzero"`
	MaxWorkers int32 `json:"max_workers"`
	IdleTimeoutS float64 `json:"idle_timeout_s"`
	Images ImageChoice `json:"images"`
	// Base URL of the data plane for this run; the path of an operation is appended to it.
	Endpoint string `json:"endpoint"`
	// 1 is next; null unless queued.
	QueuePosition NullableInt32 `json:"queue_position"`
	LiveWorkers int32 `json:"live_workers"`
	Progress Progress `json:"progress"`
	CreatedAt time.Time `json:"created_at"`
	UpdatedAt time.Time `json:"updated_at"`
	// In how many runs of this benchmark its submitter had executed an action before the first one of this run, whether they were deleted or not; absent before that action. For the profile `deletion`.
	RunsPlayedBefore *int32 `json:"runs_played_before,omitzero"`
	// How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`.
	AttemptsBySubmitter *int32 `json:"attempts_by_submitter,omitzero"`
}

// GetMode returns mode, or the zero value when it is absent.
func (o *Run) GetMode() (v string) {
	if o != nil && o.Mode != nil {
		v = *o.Mode
	}
	return v
}

// SetMode sets mode.
func (o *Run) SetMode(v string) {
	o.Mode = &v
}

// GetPolicyServer returns policy_server, or the zero value when it is absent.
func (o *Run) GetPolicyServer() (v PolicyServerView) {
	if o != nil && o.PolicyServer != nil {
		v = *o.PolicyServer
	}
	return v
}

// SetPolicyServer sets policy_server.
func (o *Run) SetPolicyServer(v PolicyServerView) {
	o.PolicyServer = &v
}

// GetAnyPolicy returns any_policy, or the zero value when it is absent.
func (o *Run) GetAnyPolicy() (v bool) {
	if o != nil && o.AnyPolicy != nil {
		v = *o.AnyPolicy
	}
	return v
}

// SetAnyPolicy sets any_policy.
func (o *Run) SetAnyPolicy(v bool) {
	o.AnyPolicy = &v
}

// GetSelect returns select, or the zero value when it is absent.
func (o *Run) GetSelect() (v SelectionView) {
	if o != nil && o.Select != nil {
		v = *o.Select
	}
	return v
}

// SetSelect sets select.
func (o *Run) SetSelect(v SelectionView) {
	o.Select = &v
}

// GetRunsPlayedBefore returns runs_played_before, or the zero value when it is absent.
func (o *Run) GetRunsPlayedBefore() (v int32) {
	if o != nil && o.RunsPlayedBefore != nil {
		v = *o.RunsPlayedBefore
	}
	return v
}

// SetRunsPlayedBefore sets runs_played_before.
func (o *Run) SetRunsPlayedBefore(v int32) {
	o.RunsPlayedBefore = &v
}

// GetAttemptsBySubmitter returns attempts_by_submitter, or the zero value when it is absent.
func (o *Run) GetAttemptsBySubmitter() (v int32) {
	if o != nil && o.AttemptsBySubmitter != nil {
		v = *o.AttemptsBySubmitter
	}
	return v
}

// SetAttemptsBySubmitter sets attempts_by_submitter.
func (o *Run) SetAttemptsBySubmitter(v int32) {
	o.AttemptsBySubmitter = &v
}
