// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"time"
	"fmt"
)

// checks if the Run type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Run{}

// Run struct for Run
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
	Mode *string `json:"mode,omitempty" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	PolicyServer *PolicyServerView `json:"policy_server,omitempty"`
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
	AdditionalProperties map[string]interface{}
}

type _Run Run

// NewRun instantiates a new Run object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewRun(runId string, state RunState, reason NullableString, retryable NullableBool, benchmarkId string, benchmarkVersion string, manifestSha256 string, policy PolicyInfo, maxWorkers int32, idleTimeoutS float64, images ImageChoice, endpoint string, queuePosition NullableInt32, liveWorkers int32, progress Progress, createdAt time.Time, updatedAt time.Time) *Run {
	this := Run{}
	this.RunId = runId
	this.State = state
	this.Reason = reason
	this.Retryable = retryable
	this.BenchmarkId = benchmarkId
	this.BenchmarkVersion = benchmarkVersion
	this.ManifestSha256 = manifestSha256
	this.Policy = policy
	this.MaxWorkers = maxWorkers
	this.IdleTimeoutS = idleTimeoutS
	this.Images = images
	this.Endpoint = endpoint
	this.QueuePosition = queuePosition
	this.LiveWorkers = liveWorkers
	this.Progress = progress
	this.CreatedAt = createdAt
	this.UpdatedAt = updatedAt
	return &this
}

// NewRunWithDefaults instantiates a new Run object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewRunWithDefaults() *Run {
	this := Run{}
	return &this
}

// GetRunId returns the RunId field value
func (o *Run) GetRunId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.RunId
}

// GetRunIdOk returns a tuple with the RunId field value
// and a boolean to check if the value has been set.
func (o *Run) GetRunIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.RunId, true
}

// SetRunId sets field value
func (o *Run) SetRunId(v string) {
	o.RunId = v
}

// GetState returns the State field value
func (o *Run) GetState() RunState {
	if o == nil {
		var ret RunState
		return ret
	}

	return o.State
}

// GetStateOk returns a tuple with the State field value
// and a boolean to check if the value has been set.
func (o *Run) GetStateOk() (*RunState, bool) {
	if o == nil {
		return nil, false
	}
	return &o.State, true
}

// SetState sets field value
func (o *Run) SetState(v RunState) {
	o.State = v
}

// GetReason returns the Reason field value
// If the value is explicit nil, the zero value for string will be returned
func (o *Run) GetReason() string {
	if o == nil || o.Reason.Get() == nil {
		var ret string
		return ret
	}

	return *o.Reason.Get()
}

// GetReasonOk returns a tuple with the Reason field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *Run) GetReasonOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return o.Reason.Get(), o.Reason.IsSet()
}

// SetReason sets field value
func (o *Run) SetReason(v string) {
	o.Reason.Set(&v)
}

// GetRetryable returns the Retryable field value
// If the value is explicit nil, the zero value for bool will be returned
func (o *Run) GetRetryable() bool {
	if o == nil || o.Retryable.Get() == nil {
		var ret bool
		return ret
	}

	return *o.Retryable.Get()
}

// GetRetryableOk returns a tuple with the Retryable field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *Run) GetRetryableOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return o.Retryable.Get(), o.Retryable.IsSet()
}

// SetRetryable sets field value
func (o *Run) SetRetryable(v bool) {
	o.Retryable.Set(&v)
}

// GetBenchmarkId returns the BenchmarkId field value
func (o *Run) GetBenchmarkId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.BenchmarkId
}

// GetBenchmarkIdOk returns a tuple with the BenchmarkId field value
// and a boolean to check if the value has been set.
func (o *Run) GetBenchmarkIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.BenchmarkId, true
}

// SetBenchmarkId sets field value
func (o *Run) SetBenchmarkId(v string) {
	o.BenchmarkId = v
}

// GetBenchmarkVersion returns the BenchmarkVersion field value
func (o *Run) GetBenchmarkVersion() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.BenchmarkVersion
}

// GetBenchmarkVersionOk returns a tuple with the BenchmarkVersion field value
// and a boolean to check if the value has been set.
func (o *Run) GetBenchmarkVersionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.BenchmarkVersion, true
}

// SetBenchmarkVersion sets field value
func (o *Run) SetBenchmarkVersion(v string) {
	o.BenchmarkVersion = v
}

// GetManifestSha256 returns the ManifestSha256 field value
func (o *Run) GetManifestSha256() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.ManifestSha256
}

// GetManifestSha256Ok returns a tuple with the ManifestSha256 field value
// and a boolean to check if the value has been set.
func (o *Run) GetManifestSha256Ok() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ManifestSha256, true
}

// SetManifestSha256 sets field value
func (o *Run) SetManifestSha256(v string) {
	o.ManifestSha256 = v
}

// GetPolicy returns the Policy field value
func (o *Run) GetPolicy() PolicyInfo {
	if o == nil {
		var ret PolicyInfo
		return ret
	}

	return o.Policy
}

// GetPolicyOk returns a tuple with the Policy field value
// and a boolean to check if the value has been set.
func (o *Run) GetPolicyOk() (*PolicyInfo, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Policy, true
}

// SetPolicy sets field value
func (o *Run) SetPolicy(v PolicyInfo) {
	o.Policy = v
}

// GetMode returns the Mode field value if set, zero value otherwise.
func (o *Run) GetMode() string {
	if o == nil || IsNil(o.Mode) {
		var ret string
		return ret
	}
	return *o.Mode
}

// GetModeOk returns a tuple with the Mode field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Run) GetModeOk() (*string, bool) {
	if o == nil || IsNil(o.Mode) {
		return nil, false
	}
	return o.Mode, true
}

// HasMode returns a boolean if a field has been set.
func (o *Run) HasMode() bool {
	if o != nil && !IsNil(o.Mode) {
		return true
	}

	return false
}

// SetMode gets a reference to the given string and assigns it to the Mode field.
func (o *Run) SetMode(v string) {
	o.Mode = &v
}

// GetPolicyServer returns the PolicyServer field value if set, zero value otherwise.
func (o *Run) GetPolicyServer() PolicyServerView {
	if o == nil || IsNil(o.PolicyServer) {
		var ret PolicyServerView
		return ret
	}
	return *o.PolicyServer
}

// GetPolicyServerOk returns a tuple with the PolicyServer field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Run) GetPolicyServerOk() (*PolicyServerView, bool) {
	if o == nil || IsNil(o.PolicyServer) {
		return nil, false
	}
	return o.PolicyServer, true
}

// HasPolicyServer returns a boolean if a field has been set.
func (o *Run) HasPolicyServer() bool {
	if o != nil && !IsNil(o.PolicyServer) {
		return true
	}

	return false
}

// SetPolicyServer gets a reference to the given PolicyServerView and assigns it to the PolicyServer field.
func (o *Run) SetPolicyServer(v PolicyServerView) {
	o.PolicyServer = &v
}

// GetMaxWorkers returns the MaxWorkers field value
func (o *Run) GetMaxWorkers() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxWorkers
}

// GetMaxWorkersOk returns a tuple with the MaxWorkers field value
// and a boolean to check if the value has been set.
func (o *Run) GetMaxWorkersOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxWorkers, true
}

// SetMaxWorkers sets field value
func (o *Run) SetMaxWorkers(v int32) {
	o.MaxWorkers = v
}

// GetIdleTimeoutS returns the IdleTimeoutS field value
func (o *Run) GetIdleTimeoutS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.IdleTimeoutS
}

// GetIdleTimeoutSOk returns a tuple with the IdleTimeoutS field value
// and a boolean to check if the value has been set.
func (o *Run) GetIdleTimeoutSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.IdleTimeoutS, true
}

// SetIdleTimeoutS sets field value
func (o *Run) SetIdleTimeoutS(v float64) {
	o.IdleTimeoutS = v
}

// GetImages returns the Images field value
func (o *Run) GetImages() ImageChoice {
	if o == nil {
		var ret ImageChoice
		return ret
	}

	return o.Images
}

// GetImagesOk returns a tuple with the Images field value
// and a boolean to check if the value has been set.
func (o *Run) GetImagesOk() (*ImageChoice, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Images, true
}

// SetImages sets field value
func (o *Run) SetImages(v ImageChoice) {
	o.Images = v
}

// GetEndpoint returns the Endpoint field value
func (o *Run) GetEndpoint() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Endpoint
}

// GetEndpointOk returns a tuple with the Endpoint field value
// and a boolean to check if the value has been set.
func (o *Run) GetEndpointOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Endpoint, true
}

// SetEndpoint sets field value
func (o *Run) SetEndpoint(v string) {
	o.Endpoint = v
}

// GetQueuePosition returns the QueuePosition field value
// If the value is explicit nil, the zero value for int32 will be returned
func (o *Run) GetQueuePosition() int32 {
	if o == nil || o.QueuePosition.Get() == nil {
		var ret int32
		return ret
	}

	return *o.QueuePosition.Get()
}

// GetQueuePositionOk returns a tuple with the QueuePosition field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *Run) GetQueuePositionOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return o.QueuePosition.Get(), o.QueuePosition.IsSet()
}

// SetQueuePosition sets field value
func (o *Run) SetQueuePosition(v int32) {
	o.QueuePosition.Set(&v)
}

// GetLiveWorkers returns the LiveWorkers field value
func (o *Run) GetLiveWorkers() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.LiveWorkers
}

// GetLiveWorkersOk returns a tuple with the LiveWorkers field value
// and a boolean to check if the value has been set.
func (o *Run) GetLiveWorkersOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.LiveWorkers, true
}

// SetLiveWorkers sets field value
func (o *Run) SetLiveWorkers(v int32) {
	o.LiveWorkers = v
}

// GetProgress returns the Progress field value
func (o *Run) GetProgress() Progress {
	if o == nil {
		var ret Progress
		return ret
	}

	return o.Progress
}

// GetProgressOk returns a tuple with the Progress field value
// and a boolean to check if the value has been set.
func (o *Run) GetProgressOk() (*Progress, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Progress, true
}

// SetProgress sets field value
func (o *Run) SetProgress(v Progress) {
	o.Progress = v
}

// GetCreatedAt returns the CreatedAt field value
func (o *Run) GetCreatedAt() time.Time {
	if o == nil {
		var ret time.Time
		return ret
	}

	return o.CreatedAt
}

// GetCreatedAtOk returns a tuple with the CreatedAt field value
// and a boolean to check if the value has been set.
func (o *Run) GetCreatedAtOk() (*time.Time, bool) {
	if o == nil {
		return nil, false
	}
	return &o.CreatedAt, true
}

// SetCreatedAt sets field value
func (o *Run) SetCreatedAt(v time.Time) {
	o.CreatedAt = v
}

// GetUpdatedAt returns the UpdatedAt field value
func (o *Run) GetUpdatedAt() time.Time {
	if o == nil {
		var ret time.Time
		return ret
	}

	return o.UpdatedAt
}

// GetUpdatedAtOk returns a tuple with the UpdatedAt field value
// and a boolean to check if the value has been set.
func (o *Run) GetUpdatedAtOk() (*time.Time, bool) {
	if o == nil {
		return nil, false
	}
	return &o.UpdatedAt, true
}

// SetUpdatedAt sets field value
func (o *Run) SetUpdatedAt(v time.Time) {
	o.UpdatedAt = v
}

func (o Run) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Run) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["run_id"] = o.RunId
	toSerialize["state"] = o.State
	toSerialize["reason"] = o.Reason.Get()
	toSerialize["retryable"] = o.Retryable.Get()
	toSerialize["benchmark_id"] = o.BenchmarkId
	toSerialize["benchmark_version"] = o.BenchmarkVersion
	toSerialize["manifest_sha256"] = o.ManifestSha256
	toSerialize["policy"] = o.Policy
	if !IsNil(o.Mode) {
		toSerialize["mode"] = o.Mode
	}
	if !IsNil(o.PolicyServer) {
		toSerialize["policy_server"] = o.PolicyServer
	}
	toSerialize["max_workers"] = o.MaxWorkers
	toSerialize["idle_timeout_s"] = o.IdleTimeoutS
	toSerialize["images"] = o.Images
	toSerialize["endpoint"] = o.Endpoint
	toSerialize["queue_position"] = o.QueuePosition.Get()
	toSerialize["live_workers"] = o.LiveWorkers
	toSerialize["progress"] = o.Progress
	toSerialize["created_at"] = o.CreatedAt
	toSerialize["updated_at"] = o.UpdatedAt

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Run) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"run_id",
		"state",
		"reason",
		"retryable",
		"benchmark_id",
		"benchmark_version",
		"manifest_sha256",
		"policy",
		"max_workers",
		"idle_timeout_s",
		"images",
		"endpoint",
		"queue_position",
		"live_workers",
		"progress",
		"created_at",
		"updated_at",
	}

	allProperties := make(map[string]interface{})

	err = json.Unmarshal(data, &allProperties)

	if err != nil {
		return err;
	}

	for _, requiredProperty := range(requiredProperties) {
		if _, exists := allProperties[requiredProperty]; !exists {
			return fmt.Errorf("no value given for required property %v", requiredProperty)
		}
	}

	varRun := _Run{}

	err = json.Unmarshal(data, &varRun)

	if err != nil {
		return err
	}

	*o = Run(varRun)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "run_id")
		delete(additionalProperties, "state")
		delete(additionalProperties, "reason")
		delete(additionalProperties, "retryable")
		delete(additionalProperties, "benchmark_id")
		delete(additionalProperties, "benchmark_version")
		delete(additionalProperties, "manifest_sha256")
		delete(additionalProperties, "policy")
		delete(additionalProperties, "mode")
		delete(additionalProperties, "policy_server")
		delete(additionalProperties, "max_workers")
		delete(additionalProperties, "idle_timeout_s")
		delete(additionalProperties, "images")
		delete(additionalProperties, "endpoint")
		delete(additionalProperties, "queue_position")
		delete(additionalProperties, "live_workers")
		delete(additionalProperties, "progress")
		delete(additionalProperties, "created_at")
		delete(additionalProperties, "updated_at")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableRun struct {
	value *Run
	isSet bool
}

func (v NullableRun) Get() *Run {
	return v.value
}

func (v *NullableRun) Set(val *Run) {
	v.value = val
	v.isSet = true
}

func (v NullableRun) IsSet() bool {
	return v.isSet
}

func (v *NullableRun) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableRun(val *Run) *NullableRun {
	return &NullableRun{value: val, isSet: true}
}

func (v NullableRun) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableRun) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
