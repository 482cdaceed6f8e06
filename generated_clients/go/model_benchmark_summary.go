// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the BenchmarkSummary type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &BenchmarkSummary{}

// BenchmarkSummary struct for BenchmarkSummary
type BenchmarkSummary struct {
	BenchmarkId string `json:"benchmark_id"`
	Version string `json:"version"`
	Title string `json:"title"`
	// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
	ManifestSha256 string `json:"manifest_sha256" validate:"regexp=^[0-9a-f]{64}$"`
	EpisodesTotal int32 `json:"episodes_total"`
	AdditionalProperties map[string]interface{}
}

type _BenchmarkSummary BenchmarkSummary

// NewBenchmarkSummary instantiates a new BenchmarkSummary object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewBenchmarkSummary(benchmarkId string, version string, title string, manifestSha256 string, episodesTotal int32) *BenchmarkSummary {
	this := BenchmarkSummary{}
	this.BenchmarkId = benchmarkId
	this.Version = version
	this.Title = title
	this.ManifestSha256 = manifestSha256
	this.EpisodesTotal = episodesTotal
	return &this
}

// NewBenchmarkSummaryWithDefaults instantiates a new BenchmarkSummary object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewBenchmarkSummaryWithDefaults() *BenchmarkSummary {
	this := BenchmarkSummary{}
	return &this
}

// GetBenchmarkId returns the BenchmarkId field value
func (o *BenchmarkSummary) GetBenchmarkId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.BenchmarkId
}

// GetBenchmarkIdOk returns a tuple with the BenchmarkId field value
// and a boolean to check if the value has been set.
func (o *BenchmarkSummary) GetBenchmarkIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.BenchmarkId, true
}

// SetBenchmarkId sets field value
func (o *BenchmarkSummary) SetBenchmarkId(v string) {
	o.BenchmarkId = v
}

// GetVersion returns the Version field value
func (o *BenchmarkSummary) GetVersion() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Version
}

// GetVersionOk returns a tuple with the Version field value
// and a boolean to check if the value has been set.
func (o *BenchmarkSummary) GetVersionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Version, true
}

// SetVersion sets field value
func (o *BenchmarkSummary) SetVersion(v string) {
	o.Version = v
}

// GetTitle returns the Title field value
func (o *BenchmarkSummary) GetTitle() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Title
}

// GetTitleOk returns a tuple with the Title field value
// and a boolean to check if the value has been set.
func (o *BenchmarkSummary) GetTitleOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Title, true
}

// SetTitle sets field value
func (o *BenchmarkSummary) SetTitle(v string) {
	o.Title = v
}

// GetManifestSha256 returns the ManifestSha256 field value
func (o *BenchmarkSummary) GetManifestSha256() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.ManifestSha256
}

// GetManifestSha256Ok returns a tuple with the ManifestSha256 field value
// and a boolean to check if the value has been set.
func (o *BenchmarkSummary) GetManifestSha256Ok() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ManifestSha256, true
}

// SetManifestSha256 sets field value
func (o *BenchmarkSummary) SetManifestSha256(v string) {
	o.ManifestSha256 = v
}

// GetEpisodesTotal returns the EpisodesTotal field value
func (o *BenchmarkSummary) GetEpisodesTotal() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.EpisodesTotal
}

// GetEpisodesTotalOk returns a tuple with the EpisodesTotal field value
// and a boolean to check if the value has been set.
func (o *BenchmarkSummary) GetEpisodesTotalOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EpisodesTotal, true
}

// SetEpisodesTotal sets field value
func (o *BenchmarkSummary) SetEpisodesTotal(v int32) {
	o.EpisodesTotal = v
}

func (o BenchmarkSummary) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o BenchmarkSummary) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["benchmark_id"] = o.BenchmarkId
	toSerialize["version"] = o.Version
	toSerialize["title"] = o.Title
	toSerialize["manifest_sha256"] = o.ManifestSha256
	toSerialize["episodes_total"] = o.EpisodesTotal

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *BenchmarkSummary) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"benchmark_id",
		"version",
		"title",
		"manifest_sha256",
		"episodes_total",
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

	varBenchmarkSummary := _BenchmarkSummary{}

	err = json.Unmarshal(data, &varBenchmarkSummary)

	if err != nil {
		return err
	}

	*o = BenchmarkSummary(varBenchmarkSummary)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "benchmark_id")
		delete(additionalProperties, "version")
		delete(additionalProperties, "title")
		delete(additionalProperties, "manifest_sha256")
		delete(additionalProperties, "episodes_total")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableBenchmarkSummary struct {
	value *BenchmarkSummary
	isSet bool
}

func (v NullableBenchmarkSummary) Get() *BenchmarkSummary {
	return v.value
}

func (v *NullableBenchmarkSummary) Set(val *BenchmarkSummary) {
	v.value = val
	v.isSet = true
}

func (v NullableBenchmarkSummary) IsSet() bool {
	return v.isSet
}

func (v *NullableBenchmarkSummary) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableBenchmarkSummary(val *BenchmarkSummary) *NullableBenchmarkSummary {
	return &NullableBenchmarkSummary{value: val, isSet: true}
}

func (v NullableBenchmarkSummary) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableBenchmarkSummary) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
