// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Score type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Score{}

// Score See scoring.md for every number here.
type Score struct {
	RunId string `json:"run_id"`
	BenchmarkId string `json:"benchmark_id"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	State RunState `json:"state"`
	Complete bool `json:"complete"`
	// Null until complete.
	Score NullableFloat64 `json:"score"`
	ScoreLow float64 `json:"score_low"`
	ScoreHigh float64 `json:"score_high"`
	Counts OutcomeCounts `json:"counts"`
	SuccessRate NullableFloat64 `json:"success_rate"`
	SuccessInterval Interval `json:"success_interval"`
	// Mean over the scored episodes.
	Mean NullableFloat64 `json:"mean"`
	MeanInterval Interval `json:"mean_interval"`
	ByTask map[string]GroupScore `json:"by_task"`
	BySplit map[string]GroupScore `json:"by_split"`
	AdditionalProperties map[string]interface{}
}

type _Score Score

// NewScore instantiates a new Score object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewScore(runId string, benchmarkId string, manifestSha256 string, state RunState, complete bool, score NullableFloat64, scoreLow float64, scoreHigh float64, counts OutcomeCounts, successRate NullableFloat64, successInterval Interval, mean NullableFloat64, meanInterval Interval, byTask map[string]GroupScore, bySplit map[string]GroupScore) *Score {
	this := Score{}
	this.RunId = runId
	this.BenchmarkId = benchmarkId
	this.ManifestSha256 = manifestSha256
	this.State = state
	this.Complete = complete
	this.Score = score
	this.ScoreLow = scoreLow
	this.ScoreHigh = scoreHigh
	this.Counts = counts
	this.SuccessRate = successRate
	this.SuccessInterval = successInterval
	this.Mean = mean
	this.MeanInterval = meanInterval
	this.ByTask = byTask
	this.BySplit = bySplit
	return &this
}

// NewScoreWithDefaults instantiates a new Score object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewScoreWithDefaults() *Score {
	this := Score{}
	return &this
}

// GetRunId returns the RunId field value
func (o *Score) GetRunId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.RunId
}

// GetRunIdOk returns a tuple with the RunId field value
// and a boolean to check if the value has been set.
func (o *Score) GetRunIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.RunId, true
}

// SetRunId sets field value
func (o *Score) SetRunId(v string) {
	o.RunId = v
}

// GetBenchmarkId returns the BenchmarkId field value
func (o *Score) GetBenchmarkId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.BenchmarkId
}

// GetBenchmarkIdOk returns a tuple with the BenchmarkId field value
// and a boolean to check if the value has been set.
func (o *Score) GetBenchmarkIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.BenchmarkId, true
}

// SetBenchmarkId sets field value
func (o *Score) SetBenchmarkId(v string) {
	o.BenchmarkId = v
}

// GetManifestSha256 returns the ManifestSha256 field value
func (o *Score) GetManifestSha256() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.ManifestSha256
}

// GetManifestSha256Ok returns a tuple with the ManifestSha256 field value
// and a boolean to check if the value has been set.
func (o *Score) GetManifestSha256Ok() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ManifestSha256, true
}

// SetManifestSha256 sets field value
func (o *Score) SetManifestSha256(v string) {
	o.ManifestSha256 = v
}

// GetState returns the State field value
func (o *Score) GetState() RunState {
	if o == nil {
		var ret RunState
		return ret
	}

	return o.State
}

// GetStateOk returns a tuple with the State field value
// and a boolean to check if the value has been set.
func (o *Score) GetStateOk() (*RunState, bool) {
	if o == nil {
		return nil, false
	}
	return &o.State, true
}

// SetState sets field value
func (o *Score) SetState(v RunState) {
	o.State = v
}

// GetComplete returns the Complete field value
func (o *Score) GetComplete() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Complete
}

// GetCompleteOk returns a tuple with the Complete field value
// and a boolean to check if the value has been set.
func (o *Score) GetCompleteOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Complete, true
}

// SetComplete sets field value
func (o *Score) SetComplete(v bool) {
	o.Complete = v
}

// GetScore returns the Score field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *Score) GetScore() float64 {
	if o == nil || o.Score.Get() == nil {
		var ret float64
		return ret
	}

	return *o.Score.Get()
}

// GetScoreOk returns a tuple with the Score field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *Score) GetScoreOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Score.Get(), o.Score.IsSet()
}

// SetScore sets field value
func (o *Score) SetScore(v float64) {
	o.Score.Set(&v)
}

// GetScoreLow returns the ScoreLow field value
func (o *Score) GetScoreLow() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.ScoreLow
}

// GetScoreLowOk returns a tuple with the ScoreLow field value
// and a boolean to check if the value has been set.
func (o *Score) GetScoreLowOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ScoreLow, true
}

// SetScoreLow sets field value
func (o *Score) SetScoreLow(v float64) {
	o.ScoreLow = v
}

// GetScoreHigh returns the ScoreHigh field value
func (o *Score) GetScoreHigh() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.ScoreHigh
}

// GetScoreHighOk returns a tuple with the ScoreHigh field value
// and a boolean to check if the value has been set.
func (o *Score) GetScoreHighOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ScoreHigh, true
}

// SetScoreHigh sets field value
func (o *Score) SetScoreHigh(v float64) {
	o.ScoreHigh = v
}

// GetCounts returns the Counts field value
func (o *Score) GetCounts() OutcomeCounts {
	if o == nil {
		var ret OutcomeCounts
		return ret
	}

	return o.Counts
}

// GetCountsOk returns a tuple with the Counts field value
// and a boolean to check if the value has been set.
func (o *Score) GetCountsOk() (*OutcomeCounts, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Counts, true
}

// SetCounts sets field value
func (o *Score) SetCounts(v OutcomeCounts) {
	o.Counts = v
}

// GetSuccessRate returns the SuccessRate field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *Score) GetSuccessRate() float64 {
	if o == nil || o.SuccessRate.Get() == nil {
		var ret float64
		return ret
	}

	return *o.SuccessRate.Get()
}

// GetSuccessRateOk returns a tuple with the SuccessRate field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *Score) GetSuccessRateOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.SuccessRate.Get(), o.SuccessRate.IsSet()
}

// SetSuccessRate sets field value
func (o *Score) SetSuccessRate(v float64) {
	o.SuccessRate.Set(&v)
}

// GetSuccessInterval returns the SuccessInterval field value
func (o *Score) GetSuccessInterval() Interval {
	if o == nil {
		var ret Interval
		return ret
	}

	return o.SuccessInterval
}

// GetSuccessIntervalOk returns a tuple with the SuccessInterval field value
// and a boolean to check if the value has been set.
func (o *Score) GetSuccessIntervalOk() (*Interval, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SuccessInterval, true
}

// SetSuccessInterval sets field value
func (o *Score) SetSuccessInterval(v Interval) {
	o.SuccessInterval = v
}

// GetMean returns the Mean field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *Score) GetMean() float64 {
	if o == nil || o.Mean.Get() == nil {
		var ret float64
		return ret
	}

	return *o.Mean.Get()
}

// GetMeanOk returns a tuple with the Mean field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *Score) GetMeanOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Mean.Get(), o.Mean.IsSet()
}

// SetMean sets field value
func (o *Score) SetMean(v float64) {
	o.Mean.Set(&v)
}

// GetMeanInterval returns the MeanInterval field value
func (o *Score) GetMeanInterval() Interval {
	if o == nil {
		var ret Interval
		return ret
	}

	return o.MeanInterval
}

// GetMeanIntervalOk returns a tuple with the MeanInterval field value
// and a boolean to check if the value has been set.
func (o *Score) GetMeanIntervalOk() (*Interval, bool) {
	if o == nil {
		return nil, false
	}
	return &o.MeanInterval, true
}

// SetMeanInterval sets field value
func (o *Score) SetMeanInterval(v Interval) {
	o.MeanInterval = v
}

// GetByTask returns the ByTask field value
func (o *Score) GetByTask() map[string]GroupScore {
	if o == nil {
		var ret map[string]GroupScore
		return ret
	}

	return o.ByTask
}

// GetByTaskOk returns a tuple with the ByTask field value
// and a boolean to check if the value has been set.
func (o *Score) GetByTaskOk() (map[string]GroupScore, bool) {
	if o == nil {
		return map[string]GroupScore{}, false
	}
	return o.ByTask, true
}

// SetByTask sets field value
func (o *Score) SetByTask(v map[string]GroupScore) {
	o.ByTask = v
}

// GetBySplit returns the BySplit field value
func (o *Score) GetBySplit() map[string]GroupScore {
	if o == nil {
		var ret map[string]GroupScore
		return ret
	}

	return o.BySplit
}

// GetBySplitOk returns a tuple with the BySplit field value
// and a boolean to check if the value has been set.
func (o *Score) GetBySplitOk() (map[string]GroupScore, bool) {
	if o == nil {
		return map[string]GroupScore{}, false
	}
	return o.BySplit, true
}

// SetBySplit sets field value
func (o *Score) SetBySplit(v map[string]GroupScore) {
	o.BySplit = v
}

func (o Score) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Score) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["run_id"] = o.RunId
	toSerialize["benchmark_id"] = o.BenchmarkId
	toSerialize["manifest_sha256"] = o.ManifestSha256
	toSerialize["state"] = o.State
	toSerialize["complete"] = o.Complete
	toSerialize["score"] = o.Score.Get()
	toSerialize["score_low"] = o.ScoreLow
	toSerialize["score_high"] = o.ScoreHigh
	toSerialize["counts"] = o.Counts
	toSerialize["success_rate"] = o.SuccessRate.Get()
	toSerialize["success_interval"] = o.SuccessInterval
	toSerialize["mean"] = o.Mean.Get()
	toSerialize["mean_interval"] = o.MeanInterval
	toSerialize["by_task"] = o.ByTask
	toSerialize["by_split"] = o.BySplit

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Score) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"run_id",
		"benchmark_id",
		"manifest_sha256",
		"state",
		"complete",
		"score",
		"score_low",
		"score_high",
		"counts",
		"success_rate",
		"success_interval",
		"mean",
		"mean_interval",
		"by_task",
		"by_split",
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

	varScore := _Score{}

	err = json.Unmarshal(data, &varScore)

	if err != nil {
		return err
	}

	*o = Score(varScore)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "run_id")
		delete(additionalProperties, "benchmark_id")
		delete(additionalProperties, "manifest_sha256")
		delete(additionalProperties, "state")
		delete(additionalProperties, "complete")
		delete(additionalProperties, "score")
		delete(additionalProperties, "score_low")
		delete(additionalProperties, "score_high")
		delete(additionalProperties, "counts")
		delete(additionalProperties, "success_rate")
		delete(additionalProperties, "success_interval")
		delete(additionalProperties, "mean")
		delete(additionalProperties, "mean_interval")
		delete(additionalProperties, "by_task")
		delete(additionalProperties, "by_split")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableScore struct {
	value *Score
	isSet bool
}

func (v NullableScore) Get() *Score {
	return v.value
}

func (v *NullableScore) Set(val *Score) {
	v.value = val
	v.isSet = true
}

func (v NullableScore) IsSet() bool {
	return v.isSet
}

func (v *NullableScore) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableScore(val *Score) *NullableScore {
	return &NullableScore{value: val, isSet: true}
}

func (v NullableScore) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableScore) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
