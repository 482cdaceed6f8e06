// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Benchmark type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Benchmark{}

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
	AdditionalProperties map[string]interface{}
}

type _Benchmark Benchmark

// NewBenchmark instantiates a new Benchmark object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewBenchmark(benchmarkId string, version string, title string, description string, manifestSha256 string, episodesTotal int32, tasks []string, splits []string, controlRateHz float64, maxSteps int32, maxChunk int32, maxAttempts int32, maxFaults int32, successRule string, actionSpace map[string]VectorSpace, observationSpace ObservationSpace, imageSizes []ImageSize, imageCodecs []string, simulator SimulatorInfo, unavailableReason NullableString) *Benchmark {
	this := Benchmark{}
	this.BenchmarkId = benchmarkId
	this.Version = version
	this.Title = title
	this.Description = description
	this.ManifestSha256 = manifestSha256
	this.EpisodesTotal = episodesTotal
	this.Tasks = tasks
	this.Splits = splits
	this.ControlRateHz = controlRateHz
	this.MaxSteps = maxSteps
	this.MaxChunk = maxChunk
	this.MaxAttempts = maxAttempts
	this.MaxFaults = maxFaults
	this.SuccessRule = successRule
	this.ActionSpace = actionSpace
	this.ObservationSpace = observationSpace
	this.ImageSizes = imageSizes
	this.ImageCodecs = imageCodecs
	this.Simulator = simulator
	this.UnavailableReason = unavailableReason
	return &this
}

// NewBenchmarkWithDefaults instantiates a new Benchmark object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewBenchmarkWithDefaults() *Benchmark {
	this := Benchmark{}
	return &this
}

// GetBenchmarkId returns the BenchmarkId field value
func (o *Benchmark) GetBenchmarkId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.BenchmarkId
}

// GetBenchmarkIdOk returns a tuple with the BenchmarkId field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetBenchmarkIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.BenchmarkId, true
}

// SetBenchmarkId sets field value
func (o *Benchmark) SetBenchmarkId(v string) {
	o.BenchmarkId = v
}

// GetVersion returns the Version field value
func (o *Benchmark) GetVersion() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Version
}

// GetVersionOk returns a tuple with the Version field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetVersionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Version, true
}

// SetVersion sets field value
func (o *Benchmark) SetVersion(v string) {
	o.Version = v
}

// GetTitle returns the Title field value
func (o *Benchmark) GetTitle() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Title
}

// GetTitleOk returns a tuple with the Title field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetTitleOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Title, true
}

// SetTitle sets field value
func (o *Benchmark) SetTitle(v string) {
	o.Title = v
}

// GetDescription returns the Description field value
func (o *Benchmark) GetDescription() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Description
}

// GetDescriptionOk returns a tuple with the Description field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetDescriptionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Description, true
}

// SetDescription sets field value
func (o *Benchmark) SetDescription(v string) {
	o.Description = v
}

// GetManifestSha256 returns the ManifestSha256 field value
func (o *Benchmark) GetManifestSha256() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.ManifestSha256
}

// GetManifestSha256Ok returns a tuple with the ManifestSha256 field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetManifestSha256Ok() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ManifestSha256, true
}

// SetManifestSha256 sets field value
func (o *Benchmark) SetManifestSha256(v string) {
	o.ManifestSha256 = v
}

// GetEpisodesTotal returns the EpisodesTotal field value
func (o *Benchmark) GetEpisodesTotal() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.EpisodesTotal
}

// GetEpisodesTotalOk returns a tuple with the EpisodesTotal field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetEpisodesTotalOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodesTotal, true
}

// SetEpisodesTotal sets field value
func (o *Benchmark) SetEpisodesTotal(v int32) {
	o.EpisodesTotal = v
}

// GetTasks returns the Tasks field value
func (o *Benchmark) GetTasks() []string {
	if o == nil {
		var ret []string
		return ret
	}

	return o.Tasks
}

// GetTasksOk returns a tuple with the Tasks field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetTasksOk() ([]string, bool) {
	if o == nil {
		return nil, false
	}
	return o.Tasks, true
}

// SetTasks sets field value
func (o *Benchmark) SetTasks(v []string) {
	o.Tasks = v
}

// GetSplits returns the Splits field value
func (o *Benchmark) GetSplits() []string {
	if o == nil {
		var ret []string
		return ret
	}

	return o.Splits
}

// GetSplitsOk returns a tuple with the Splits field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetSplitsOk() ([]string, bool) {
	if o == nil {
		return nil, false
	}
	return o.Splits, true
}

// SetSplits sets field value
func (o *Benchmark) SetSplits(v []string) {
	o.Splits = v
}

// GetControlRateHz returns the ControlRateHz field value
func (o *Benchmark) GetControlRateHz() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.ControlRateHz
}

// GetControlRateHzOk returns a tuple with the ControlRateHz field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetControlRateHzOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ControlRateHz, true
}

// SetControlRateHz sets field value
func (o *Benchmark) SetControlRateHz(v float64) {
	o.ControlRateHz = v
}

// GetMaxSteps returns the MaxSteps field value
func (o *Benchmark) GetMaxSteps() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxSteps
}

// GetMaxStepsOk returns a tuple with the MaxSteps field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetMaxStepsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxSteps, true
}

// SetMaxSteps sets field value
func (o *Benchmark) SetMaxSteps(v int32) {
	o.MaxSteps = v
}

// GetMaxChunk returns the MaxChunk field value
func (o *Benchmark) GetMaxChunk() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxChunk
}

// GetMaxChunkOk returns a tuple with the MaxChunk field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetMaxChunkOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxChunk, true
}

// SetMaxChunk sets field value
func (o *Benchmark) SetMaxChunk(v int32) {
	o.MaxChunk = v
}

// GetMaxAttempts returns the MaxAttempts field value
func (o *Benchmark) GetMaxAttempts() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxAttempts
}

// GetMaxAttemptsOk returns a tuple with the MaxAttempts field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetMaxAttemptsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxAttempts, true
}

// SetMaxAttempts sets field value
func (o *Benchmark) SetMaxAttempts(v int32) {
	o.MaxAttempts = v
}

// GetMaxFaults returns the MaxFaults field value
func (o *Benchmark) GetMaxFaults() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.MaxFaults
}

// GetMaxFaultsOk returns a tuple with the MaxFaults field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetMaxFaultsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MaxFaults, true
}

// SetMaxFaults sets field value
func (o *Benchmark) SetMaxFaults(v int32) {
	o.MaxFaults = v
}

// GetSuccessRule returns the SuccessRule field value
func (o *Benchmark) GetSuccessRule() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.SuccessRule
}

// GetSuccessRuleOk returns a tuple with the SuccessRule field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetSuccessRuleOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SuccessRule, true
}

// SetSuccessRule sets field value
func (o *Benchmark) SetSuccessRule(v string) {
	o.SuccessRule = v
}

// GetActionSpace returns the ActionSpace field value
func (o *Benchmark) GetActionSpace() map[string]VectorSpace {
	if o == nil {
		var ret map[string]VectorSpace
		return ret
	}

	return o.ActionSpace
}

// GetActionSpaceOk returns a tuple with the ActionSpace field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetActionSpaceOk() (map[string]VectorSpace, bool) {
	if o == nil {
		return map[string]VectorSpace{}, false
	}
	return o.ActionSpace, true
}

// SetActionSpace sets field value
func (o *Benchmark) SetActionSpace(v map[string]VectorSpace) {
	o.ActionSpace = v
}

// GetObservationSpace returns the ObservationSpace field value
func (o *Benchmark) GetObservationSpace() ObservationSpace {
	if o == nil {
		var ret ObservationSpace
		return ret
	}

	return o.ObservationSpace
}

// GetObservationSpaceOk returns a tuple with the ObservationSpace field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetObservationSpaceOk() (*ObservationSpace, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ObservationSpace, true
}

// SetObservationSpace sets field value
func (o *Benchmark) SetObservationSpace(v ObservationSpace) {
	o.ObservationSpace = v
}

// GetImageSizes returns the ImageSizes field value
func (o *Benchmark) GetImageSizes() []ImageSize {
	if o == nil {
		var ret []ImageSize
		return ret
	}

	return o.ImageSizes
}

// GetImageSizesOk returns a tuple with the ImageSizes field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetImageSizesOk() ([]ImageSize, bool) {
	if o == nil {
		return nil, false
	}
	return o.ImageSizes, true
}

// SetImageSizes sets field value
func (o *Benchmark) SetImageSizes(v []ImageSize) {
	o.ImageSizes = v
}

// GetImageCodecs returns the ImageCodecs field value
func (o *Benchmark) GetImageCodecs() []string {
	if o == nil {
		var ret []string
		return ret
	}

	return o.ImageCodecs
}

// GetImageCodecsOk returns a tuple with the ImageCodecs field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetImageCodecsOk() ([]string, bool) {
	if o == nil {
		return nil, false
	}
	return o.ImageCodecs, true
}

// SetImageCodecs sets field value
func (o *Benchmark) SetImageCodecs(v []string) {
	o.ImageCodecs = v
}

// GetSimulator returns the Simulator field value
func (o *Benchmark) GetSimulator() SimulatorInfo {
	if o == nil {
		var ret SimulatorInfo
		return ret
	}

	return o.Simulator
}

// GetSimulatorOk returns a tuple with the Simulator field value
// and a boolean to check if the value has been set.
func (o *Benchmark) GetSimulatorOk() (*SimulatorInfo, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Simulator, true
}

// SetSimulator sets field value
func (o *Benchmark) SetSimulator(v SimulatorInfo) {
	o.Simulator = v
}

// GetUnavailableReason returns the UnavailableReason field value
// If the value is explicit nil, the zero value for string will be returned
func (o *Benchmark) GetUnavailableReason() string {
	if o == nil || o.UnavailableReason.Get() == nil {
		var ret string
		return ret
	}

	return *o.UnavailableReason.Get()
}

// GetUnavailableReasonOk returns a tuple with the UnavailableReason field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *Benchmark) GetUnavailableReasonOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return o.UnavailableReason.Get(), o.UnavailableReason.IsSet()
}

// SetUnavailableReason sets field value
func (o *Benchmark) SetUnavailableReason(v string) {
	o.UnavailableReason.Set(&v)
}

func (o Benchmark) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Benchmark) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["benchmark_id"] = o.BenchmarkId
	toSerialize["version"] = o.Version
	toSerialize["title"] = o.Title
	toSerialize["description"] = o.Description
	toSerialize["manifest_sha256"] = o.ManifestSha256
	toSerialize["episodes_total"] = o.EpisodesTotal
	toSerialize["tasks"] = o.Tasks
	toSerialize["splits"] = o.Splits
	toSerialize["control_rate_hz"] = o.ControlRateHz
	toSerialize["max_steps"] = o.MaxSteps
	toSerialize["max_chunk"] = o.MaxChunk
	toSerialize["max_attempts"] = o.MaxAttempts
	toSerialize["max_faults"] = o.MaxFaults
	toSerialize["success_rule"] = o.SuccessRule
	toSerialize["action_space"] = o.ActionSpace
	toSerialize["observation_space"] = o.ObservationSpace
	toSerialize["image_sizes"] = o.ImageSizes
	toSerialize["image_codecs"] = o.ImageCodecs
	toSerialize["simulator"] = o.Simulator
	toSerialize["unavailable_reason"] = o.UnavailableReason.Get()

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Benchmark) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"benchmark_id",
		"version",
		"title",
		"description",
		"manifest_sha256",
		"episodes_total",
		"tasks",
		"splits",
		"control_rate_hz",
		"max_steps",
		"max_chunk",
		"max_attempts",
		"max_faults",
		"success_rule",
		"action_space",
		"observation_space",
		"image_sizes",
		"image_codecs",
		"simulator",
		"unavailable_reason",
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

	varBenchmark := _Benchmark{}

	err = json.Unmarshal(data, &varBenchmark)

	if err != nil {
		return err
	}

	*o = Benchmark(varBenchmark)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "benchmark_id")
		delete(additionalProperties, "version")
		delete(additionalProperties, "title")
		delete(additionalProperties, "description")
		delete(additionalProperties, "manifest_sha256")
		delete(additionalProperties, "episodes_total")
		delete(additionalProperties, "tasks")
		delete(additionalProperties, "splits")
		delete(additionalProperties, "control_rate_hz")
		delete(additionalProperties, "max_steps")
		delete(additionalProperties, "max_chunk")
		delete(additionalProperties, "max_attempts")
		delete(additionalProperties, "max_faults")
		delete(additionalProperties, "success_rule")
		delete(additionalProperties, "action_space")
		delete(additionalProperties, "observation_space")
		delete(additionalProperties, "image_sizes")
		delete(additionalProperties, "image_codecs")
		delete(additionalProperties, "simulator")
		delete(additionalProperties, "unavailable_reason")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableBenchmark struct {
	value *Benchmark
	isSet bool
}

func (v NullableBenchmark) Get() *Benchmark {
	return v.value
}

func (v *NullableBenchmark) Set(val *Benchmark) {
	v.value = val
	v.isSet = true
}

func (v NullableBenchmark) IsSet() bool {
	return v.isSet
}

func (v *NullableBenchmark) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableBenchmark(val *Benchmark) *NullableBenchmark {
	return &NullableBenchmark{value: val, isSet: true}
}

func (v NullableBenchmark) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableBenchmark) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
