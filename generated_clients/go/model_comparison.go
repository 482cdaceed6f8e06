// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Comparison type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Comparison{}

// Comparison See scoring.md for every number here.
type Comparison struct {
	// Id of the run that the others are compared with.
	Baseline string `json:"baseline"`
	BenchmarkId string `json:"benchmark_id"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	Tolerance float64 `json:"tolerance"`
	// One entry per run that was named, in that order.
	Runs []ComparedRun `json:"runs"`
	AdditionalProperties map[string]interface{}
}

type _Comparison Comparison

// NewComparison instantiates a new Comparison object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewComparison(baseline string, benchmarkId string, manifestSha256 string, tolerance float64, runs []ComparedRun) *Comparison {
	this := Comparison{}
	this.Baseline = baseline
	this.BenchmarkId = benchmarkId
	this.ManifestSha256 = manifestSha256
	this.Tolerance = tolerance
	this.Runs = runs
	return &this
}

// NewComparisonWithDefaults instantiates a new Comparison object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewComparisonWithDefaults() *Comparison {
	this := Comparison{}
	return &this
}

// GetBaseline returns the Baseline field value
func (o *Comparison) GetBaseline() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Baseline
}

// GetBaselineOk returns a tuple with the Baseline field value
// and a boolean to check if the value has been set.
func (o *Comparison) GetBaselineOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Baseline, true
}

// SetBaseline sets field value
func (o *Comparison) SetBaseline(v string) {
	o.Baseline = v
}

// GetBenchmarkId returns the BenchmarkId field value
func (o *Comparison) GetBenchmarkId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.BenchmarkId
}

// GetBenchmarkIdOk returns a tuple with the BenchmarkId field value
// and a boolean to check if the value has been set.
func (o *Comparison) GetBenchmarkIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.BenchmarkId, true
}

// SetBenchmarkId sets field value
func (o *Comparison) SetBenchmarkId(v string) {
	o.BenchmarkId = v
}

// GetManifestSha256 returns the ManifestSha256 field value
func (o *Comparison) GetManifestSha256() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.ManifestSha256
}

// GetManifestSha256Ok returns a tuple with the ManifestSha256 field value
// and a boolean to check if the value has been set.
func (o *Comparison) GetManifestSha256Ok() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ManifestSha256, true
}

// SetManifestSha256 sets field value
func (o *Comparison) SetManifestSha256(v string) {
	o.ManifestSha256 = v
}

// GetTolerance returns the Tolerance field value
func (o *Comparison) GetTolerance() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.Tolerance
}

// GetToleranceOk returns a tuple with the Tolerance field value
// and a boolean to check if the value has been set.
func (o *Comparison) GetToleranceOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Tolerance, true
}

// SetTolerance sets field value
func (o *Comparison) SetTolerance(v float64) {
	o.Tolerance = v
}

// GetRuns returns the Runs field value
func (o *Comparison) GetRuns() []ComparedRun {
	if o == nil {
		var ret []ComparedRun
		return ret
	}

	return o.Runs
}

// GetRunsOk returns a tuple with the Runs field value
// and a boolean to check if the value has been set.
func (o *Comparison) GetRunsOk() ([]ComparedRun, bool) {
	if o == nil {
		return nil, false
	}
	return o.Runs, true
}

// SetRuns sets field value
func (o *Comparison) SetRuns(v []ComparedRun) {
	o.Runs = v
}

func (o Comparison) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Comparison) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["baseline"] = o.Baseline
	toSerialize["benchmark_id"] = o.BenchmarkId
	toSerialize["manifest_sha256"] = o.ManifestSha256
	toSerialize["tolerance"] = o.Tolerance
	toSerialize["runs"] = o.Runs

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Comparison) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"baseline",
		"benchmark_id",
		"manifest_sha256",
		"tolerance",
		"runs",
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

	varComparison := _Comparison{}

	err = json.Unmarshal(data, &varComparison)

	if err != nil {
		return err
	}

	*o = Comparison(varComparison)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "baseline")
		delete(additionalProperties, "benchmark_id")
		delete(additionalProperties, "manifest_sha256")
		delete(additionalProperties, "tolerance")
		delete(additionalProperties, "runs")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableComparison struct {
	value *Comparison
	isSet bool
}

func (v NullableComparison) Get() *Comparison {
	return v.value
}

func (v *NullableComparison) Set(val *Comparison) {
	v.value = val
	v.isSet = true
}

func (v NullableComparison) IsSet() bool {
	return v.isSet
}

func (v *NullableComparison) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableComparison(val *Comparison) *NullableComparison {
	return &NullableComparison{value: val, isSet: true}
}

func (v NullableComparison) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableComparison) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
