// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// Limits is a message of the protocol.
type Limits struct {
	// Longest request body that is read.
	MaxBodyBytes int64 `json:"max_body_bytes"`
	// Most live workers a run may ask for.
	MaxWorkers int32 `json:"max_workers"`
	// Most actions in one predict; a benchmark may allow fewer.
	MaxChunk int32 `json:"max_chunk"`
	IdleTimeoutSMin float64 `json:"idle_timeout_s_min"`
	IdleTimeoutSMax float64 `json:"idle_timeout_s_max"`
	// Longest wait that a long-poll is granted.
	WaitSMax int32 `json:"wait_s_max"`
	// Longest request line with its headers that is read; for the profile `limits`.
	MaxHeaderBytes *int32 `json:"max_header_bytes,omitzero"`
	// Time in which the headers of a request are complete, from its first byte; for the profile `limits`.
	HeaderTimeoutS *float64 `json:"header_timeout_s,omitzero"`
	// Time in which a part of a body arrives after the headers of its request; for the profile `limits`.
	BodyTimeoutS *float64 `json:"body_timeout_s,omitzero"`
	// Longest time that a session lives without a new turn, whatever its `idle_timeout_s`; for the profile `limits`.
	HeartbeatSMax *float64 `json:"heartbeat_s_max,omitzero"`
	// When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`.
	UnusedSMax *float64 `json:"unused_s_max,omitzero"`
	// Longest body that is read of a request other than `predict`, where it is less than `max_body_bytes`; for the profile `limits`.
	MaxControlBodyBytes *int64 `json:"max_control_body_bytes,omitzero"`
	// Most runs of one account that are queued, ready, running or stopping; for the profile `limits`.
	MaxOpenRuns *int32 `json:"max_open_runs,omitzero"`
	// Most Idempotency-Keys that one account may use; for the profile `limits`.
	MaxIdempotencyKeys *int64 `json:"max_idempotency_keys,omitzero"`
	// Most bytes that the submissions of one account may have together; what else a server stores for a run may count, too. For the profile `limits`.
	MaxStoredBytes *int64 `json:"max_stored_bytes,omitzero"`
	// Longest archive that `import_record` reads; for the profile `record_import`.
	MaxRecordBytes *int64 `json:"max_record_bytes,omitzero"`
	// Most imports of one account that are not `finished`; for the profile `record_import`.
	MaxWaitingImports *int32 `json:"max_waiting_imports,omitzero"`
	// Most bytes that the archives of one account may have together; for the profile `record_import`.
	MaxImportedBytes *int64 `json:"max_imported_bytes,omitzero"`
	// Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`.
	RunKeepDays *float64 `json:"run_keep_days,omitzero"`
}

// GetMaxHeaderBytes returns max_header_bytes, or the zero value when it is absent.
func (o *Limits) GetMaxHeaderBytes() (v int32) {
	if o != nil && o.MaxHeaderBytes != nil {
		v = *o.MaxHeaderBytes
	}
	return v
}

// SetMaxHeaderBytes sets max_header_bytes.
func (o *Limits) SetMaxHeaderBytes(v int32) {
	o.MaxHeaderBytes = &v
}

// GetHeaderTimeoutS returns header_timeout_s, or the zero value when it is absent.
func (o *Limits) GetHeaderTimeoutS() (v float64) {
	if o != nil && o.HeaderTimeoutS != nil {
		v = *o.HeaderTimeoutS
	}
	return v
}

// SetHeaderTimeoutS sets header_timeout_s.
func (o *Limits) SetHeaderTimeoutS(v float64) {
	o.HeaderTimeoutS = &v
}

// GetBodyTimeoutS returns body_timeout_s, or the zero value when it is absent.
func (o *Limits) GetBodyTimeoutS() (v float64) {
	if o != nil && o.BodyTimeoutS != nil {
		v = *o.BodyTimeoutS
	}
	return v
}

// SetBodyTimeoutS sets body_timeout_s.
func (o *Limits) SetBodyTimeoutS(v float64) {
	o.BodyTimeoutS = &v
}

// GetHeartbeatSMax returns heartbeat_s_max, or the zero value when it is absent.
func (o *Limits) GetHeartbeatSMax() (v float64) {
	if o != nil && o.HeartbeatSMax != nil {
		v = *o.HeartbeatSMax
	}
	return v
}

// SetHeartbeatSMax sets heartbeat_s_max.
func (o *Limits) SetHeartbeatSMax(v float64) {
	o.HeartbeatSMax = &v
}

// GetUnusedSMax returns unused_s_max, or the zero value when it is absent.
func (o *Limits) GetUnusedSMax() (v float64) {
	if o != nil && o.UnusedSMax != nil {
		v = *o.UnusedSMax
	}
	return v
}

// SetUnusedSMax sets unused_s_max.
func (o *Limits) SetUnusedSMax(v float64) {
	o.UnusedSMax = &v
}

// GetMaxControlBodyBytes returns max_control_body_bytes, or the zero value when it is absent.
func (o *Limits) GetMaxControlBodyBytes() (v int64) {
	if o != nil && o.MaxControlBodyBytes != nil {
		v = *o.MaxControlBodyBytes
	}
	return v
}

// SetMaxControlBodyBytes sets max_control_body_bytes.
func (o *Limits) SetMaxControlBodyBytes(v int64) {
	o.MaxControlBodyBytes = &v
}

// GetMaxOpenRuns returns max_open_runs, or the zero value when it is absent.
func (o *Limits) GetMaxOpenRuns() (v int32) {
	if o != nil && o.MaxOpenRuns != nil {
		v = *o.MaxOpenRuns
	}
	return v
}

// SetMaxOpenRuns sets max_open_runs.
func (o *Limits) SetMaxOpenRuns(v int32) {
	o.MaxOpenRuns = &v
}

// GetMaxIdempotencyKeys returns max_idempotency_keys, or the zero value when it is absent.
func (o *Limits) GetMaxIdempotencyKeys() (v int64) {
	if o != nil && o.MaxIdempotencyKeys != nil {
		v = *o.MaxIdempotencyKeys
	}
	return v
}

// SetMaxIdempotencyKeys sets max_idempotency_keys.
func (o *Limits) SetMaxIdempotencyKeys(v int64) {
	o.MaxIdempotencyKeys = &v
}

// GetMaxStoredBytes returns max_stored_bytes, or the zero value when it is absent.
func (o *Limits) GetMaxStoredBytes() (v int64) {
	if o != nil && o.MaxStoredBytes != nil {
		v = *o.MaxStoredBytes
	}
	return v
}

// SetMaxStoredBytes sets max_stored_bytes.
func (o *Limits) SetMaxStoredBytes(v int64) {
	o.MaxStoredBytes = &v
}

// GetMaxRecordBytes returns max_record_bytes, or the zero value when it is absent.
func (o *Limits) GetMaxRecordBytes() (v int64) {
	if o != nil && o.MaxRecordBytes != nil {
		v = *o.MaxRecordBytes
	}
	return v
}

// SetMaxRecordBytes sets max_record_bytes.
func (o *Limits) SetMaxRecordBytes(v int64) {
	o.MaxRecordBytes = &v
}

// GetMaxWaitingImports returns max_waiting_imports, or the zero value when it is absent.
func (o *Limits) GetMaxWaitingImports() (v int32) {
	if o != nil && o.MaxWaitingImports != nil {
		v = *o.MaxWaitingImports
	}
	return v
}

// SetMaxWaitingImports sets max_waiting_imports.
func (o *Limits) SetMaxWaitingImports(v int32) {
	o.MaxWaitingImports = &v
}

// GetMaxImportedBytes returns max_imported_bytes, or the zero value when it is absent.
func (o *Limits) GetMaxImportedBytes() (v int64) {
	if o != nil && o.MaxImportedBytes != nil {
		v = *o.MaxImportedBytes
	}
	return v
}

// SetMaxImportedBytes sets max_imported_bytes.
func (o *Limits) SetMaxImportedBytes(v int64) {
	o.MaxImportedBytes = &v
}

// GetRunKeepDays returns run_keep_days, or the zero value when it is absent.
func (o *Limits) GetRunKeepDays() (v float64) {
	if o != nil && o.RunKeepDays != nil {
		v = *o.RunKeepDays
	}
	return v
}

// SetRunKeepDays sets run_keep_days.
func (o *Limits) SetRunKeepDays(v float64) {
	o.RunKeepDays = &v
}
