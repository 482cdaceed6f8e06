// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the ComparedRun type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &ComparedRun{}

// ComparedRun One run beside the baseline. A pair is an episode that both have scored.
type ComparedRun struct {
	RunId string `json:"run_id"`
	// Both runs have scored every episode.
	Complete bool `json:"complete"`
	// Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
	Release bool `json:"release"`
	// Number of pairs.
	Paired int32 `json:"paired"`
	// Mean score of the baseline over the pairs.
	BaselineMean NullableFloat64 `json:"baseline_mean"`
	// Mean score of the run over the pairs.
	Mean NullableFloat64 `json:"mean"`
	// Baseline minus run: positive when the run is worse.
	Difference NullableFloat64 `json:"difference"`
	// Pairs in which the run alone succeeds.
	Wins int32 `json:"wins"`
	// Pairs in which the baseline alone succeeds.
	Losses int32 `json:"losses"`
	// Pairs in which both succeed or neither does.
	Ties int32 `json:"ties"`
	// McNemar's exact test, two-sided.
	PValue float64 `json:"p_value"`
	// Task → the pairs of its episodes.
	ByTask map[string]ComparedTask `json:"by_task"`
	AdditionalProperties map[string]interface{}
}

type _ComparedRun ComparedRun

// NewComparedRun instantiates a new ComparedRun object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewComparedRun(runId string, complete bool, release bool, paired int32, baselineMean NullableFloat64, mean NullableFloat64, difference NullableFloat64, wins int32, losses int32, ties int32, pValue float64, byTask map[string]ComparedTask) *ComparedRun {
	this := ComparedRun{}
	this.RunId = runId
	this.Complete = complete
	this.Release = release
	this.Paired = paired
	this.BaselineMean = baselineMean
	this.Mean = mean
	this.Difference = difference
	this.Wins = wins
	this.Losses = losses
	this.Ties = ties
	this.PValue = pValue
	this.ByTask = byTask
	return &this
}

// NewComparedRunWithDefaults instantiates a new ComparedRun object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewComparedRunWithDefaults() *ComparedRun {
	this := ComparedRun{}
	return &this
}

// GetRunId returns the RunId field value
func (o *ComparedRun) GetRunId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.RunId
}

// GetRunIdOk returns a tuple with the RunId field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetRunIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.RunId, true
}

// SetRunId sets field value
func (o *ComparedRun) SetRunId(v string) {
	o.RunId = v
}

// GetComplete returns the Complete field value
func (o *ComparedRun) GetComplete() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Complete
}

// GetCompleteOk returns a tuple with the Complete field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetCompleteOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Complete, true
}

// SetComplete sets field value
func (o *ComparedRun) SetComplete(v bool) {
	o.Complete = v
}

// GetRelease returns the Release field value
func (o *ComparedRun) GetRelease() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Release
}

// GetReleaseOk returns a tuple with the Release field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetReleaseOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Release, true
}

// SetRelease sets field value
func (o *ComparedRun) SetRelease(v bool) {
	o.Release = v
}

// GetPaired returns the Paired field value
func (o *ComparedRun) GetPaired() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Paired
}

// GetPairedOk returns a tuple with the Paired field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetPairedOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Paired, true
}

// SetPaired sets field value
func (o *ComparedRun) SetPaired(v int32) {
	o.Paired = v
}

// GetBaselineMean returns the BaselineMean field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *ComparedRun) GetBaselineMean() float64 {
	if o == nil || o.BaselineMean.Get() == nil {
		var ret float64
		return ret
	}

	return *o.BaselineMean.Get()
}

// GetBaselineMeanOk returns a tuple with the BaselineMean field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *ComparedRun) GetBaselineMeanOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.BaselineMean.Get(), o.BaselineMean.IsSet()
}

// SetBaselineMean sets field value
func (o *ComparedRun) SetBaselineMean(v float64) {
	o.BaselineMean.Set(&v)
}

// GetMean returns the Mean field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *ComparedRun) GetMean() float64 {
	if o == nil || o.Mean.Get() == nil {
		var ret float64
		return ret
	}

	return *o.Mean.Get()
}

// GetMeanOk returns a tuple with the Mean field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *ComparedRun) GetMeanOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Mean.Get(), o.Mean.IsSet()
}

// SetMean sets field value
func (o *ComparedRun) SetMean(v float64) {
	o.Mean.Set(&v)
}

// GetDifference returns the Difference field value
// If the value is explicit nil, the zero value for float64 will be returned
func (o *ComparedRun) GetDifference() float64 {
	if o == nil || o.Difference.Get() == nil {
		var ret float64
		return ret
	}

	return *o.Difference.Get()
}

// GetDifferenceOk returns a tuple with the Difference field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *ComparedRun) GetDifferenceOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return o.Difference.Get(), o.Difference.IsSet()
}

// SetDifference sets field value
func (o *ComparedRun) SetDifference(v float64) {
	o.Difference.Set(&v)
}

// GetWins returns the Wins field value
func (o *ComparedRun) GetWins() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Wins
}

// GetWinsOk returns a tuple with the Wins field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetWinsOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Wins, true
}

// SetWins sets field value
func (o *ComparedRun) SetWins(v int32) {
	o.Wins = v
}

// GetLosses returns the Losses field value
func (o *ComparedRun) GetLosses() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Losses
}

// GetLossesOk returns a tuple with the Losses field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetLossesOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Losses, true
}

// SetLosses sets field value
func (o *ComparedRun) SetLosses(v int32) {
	o.Losses = v
}

// GetTies returns the Ties field value
func (o *ComparedRun) GetTies() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Ties
}

// GetTiesOk returns a tuple with the Ties field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetTiesOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Ties, true
}

// SetTies sets field value
func (o *ComparedRun) SetTies(v int32) {
	o.Ties = v
}

// GetPValue returns the PValue field value
func (o *ComparedRun) GetPValue() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.PValue
}

// GetPValueOk returns a tuple with the PValue field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetPValueOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.PValue, true
}

// SetPValue sets field value
func (o *ComparedRun) SetPValue(v float64) {
	o.PValue = v
}

// GetByTask returns the ByTask field value
func (o *ComparedRun) GetByTask() map[string]ComparedTask {
	if o == nil {
		var ret map[string]ComparedTask
		return ret
	}

	return o.ByTask
}

// GetByTaskOk returns a tuple with the ByTask field value
// and a boolean to check if the value has been set.
func (o *ComparedRun) GetByTaskOk() (map[string]ComparedTask, bool) {
	if o == nil {
		return map[string]ComparedTask{}, false
	}
	return o.ByTask, true
}

// SetByTask sets field value
func (o *ComparedRun) SetByTask(v map[string]ComparedTask) {
	o.ByTask = v
}

func (o ComparedRun) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o ComparedRun) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["run_id"] = o.RunId
	toSerialize["complete"] = o.Complete
	toSerialize["release"] = o.Release
	toSerialize["paired"] = o.Paired
	toSerialize["baseline_mean"] = o.BaselineMean.Get()
	toSerialize["mean"] = o.Mean.Get()
	toSerialize["difference"] = o.Difference.Get()
	toSerialize["wins"] = o.Wins
	toSerialize["losses"] = o.Losses
	toSerialize["ties"] = o.Ties
	toSerialize["p_value"] = o.PValue
	toSerialize["by_task"] = o.ByTask

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *ComparedRun) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"run_id",
		"complete",
		"release",
		"paired",
		"baseline_mean",
		"mean",
		"difference",
		"wins",
		"losses",
		"ties",
		"p_value",
		"by_task",
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

	varComparedRun := _ComparedRun{}

	err = json.Unmarshal(data, &varComparedRun)

	if err != nil {
		return err
	}

	*o = ComparedRun(varComparedRun)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "run_id")
		delete(additionalProperties, "complete")
		delete(additionalProperties, "release")
		delete(additionalProperties, "paired")
		delete(additionalProperties, "baseline_mean")
		delete(additionalProperties, "mean")
		delete(additionalProperties, "difference")
		delete(additionalProperties, "wins")
		delete(additionalProperties, "losses")
		delete(additionalProperties, "ties")
		delete(additionalProperties, "p_value")
		delete(additionalProperties, "by_task")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableComparedRun struct {
	value *ComparedRun
	isSet bool
}

func (v NullableComparedRun) Get() *ComparedRun {
	return v.value
}

func (v *NullableComparedRun) Set(val *ComparedRun) {
	v.value = val
	v.isSet = true
}

func (v NullableComparedRun) IsSet() bool {
	return v.isSet
}

func (v *NullableComparedRun) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableComparedRun(val *ComparedRun) *NullableComparedRun {
	return &NullableComparedRun{value: val, isSet: true}
}

func (v NullableComparedRun) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableComparedRun) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
