// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the SubmitRun type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &SubmitRun{}

// SubmitRun struct for SubmitRun
type SubmitRun struct {
	BenchmarkId string `json:"benchmark_id" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Policy PolicyInfo `json:"policy"`
	// Most live workers wanted; the server's limit when absent.
	MaxWorkers *int32 `json:"max_workers,omitempty"`
	// Lease of a session; the server's maximum when absent.
	IdleTimeoutS *float64 `json:"idle_timeout_s,omitempty"`
	Images *ImageChoice `json:"images,omitempty"`
	Options *CalibrationOptions `json:"options,omitempty"`
	Mode *RunMode `json:"mode,omitempty"`
	PolicyServer *PolicyServer `json:"policy_server,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _SubmitRun SubmitRun

// NewSubmitRun instantiates a new SubmitRun object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewSubmitRun(benchmarkId string, policy PolicyInfo) *SubmitRun {
	this := SubmitRun{}
	this.BenchmarkId = benchmarkId
	this.Policy = policy
	return &this
}

// NewSubmitRunWithDefaults instantiates a new SubmitRun object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewSubmitRunWithDefaults() *SubmitRun {
	this := SubmitRun{}
	return &this
}

// GetBenchmarkId returns the BenchmarkId field value
func (o *SubmitRun) GetBenchmarkId() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.BenchmarkId
}

// GetBenchmarkIdOk returns a tuple with the BenchmarkId field value
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetBenchmarkIdOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.BenchmarkId, true
}

// SetBenchmarkId sets field value
func (o *SubmitRun) SetBenchmarkId(v string) {
	o.BenchmarkId = v
}

// GetPolicy returns the Policy field value
func (o *SubmitRun) GetPolicy() PolicyInfo {
	if o == nil {
		var ret PolicyInfo
		return ret
	}

	return o.Policy
}

// GetPolicyOk returns a tuple with the Policy field value
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetPolicyOk() (*PolicyInfo, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Policy, true
}

// SetPolicy sets field value
func (o *SubmitRun) SetPolicy(v PolicyInfo) {
	o.Policy = v
}

// GetMaxWorkers returns the MaxWorkers field value if set, zero value otherwise.
func (o *SubmitRun) GetMaxWorkers() int32 {
	if o == nil || IsNil(o.MaxWorkers) {
		var ret int32
		return ret
	}
	return *o.MaxWorkers
}

// GetMaxWorkersOk returns a tuple with the MaxWorkers field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetMaxWorkersOk() (*int32, bool) {
	if o == nil || IsNil(o.MaxWorkers) {
		return nil, false
	}
	return o.MaxWorkers, true
}

// HasMaxWorkers returns a boolean if a field has been set.
func (o *SubmitRun) HasMaxWorkers() bool {
	if o != nil && !IsNil(o.MaxWorkers) {
		return true
	}

	return false
}

// SetMaxWorkers gets a reference to the given int32 and assigns it to the MaxWorkers field.
func (o *SubmitRun) SetMaxWorkers(v int32) {
	o.MaxWorkers = &v
}

// GetIdleTimeoutS returns the IdleTimeoutS field value if set, zero value otherwise.
func (o *SubmitRun) GetIdleTimeoutS() float64 {
	if o == nil || IsNil(o.IdleTimeoutS) {
		var ret float64
		return ret
	}
	return *o.IdleTimeoutS
}

// GetIdleTimeoutSOk returns a tuple with the IdleTimeoutS field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetIdleTimeoutSOk() (*float64, bool) {
	if o == nil || IsNil(o.IdleTimeoutS) {
		return nil, false
	}
	return o.IdleTimeoutS, true
}

// HasIdleTimeoutS returns a boolean if a field has been set.
func (o *SubmitRun) HasIdleTimeoutS() bool {
	if o != nil && !IsNil(o.IdleTimeoutS) {
		return true
	}

	return false
}

// SetIdleTimeoutS gets a reference to the given float64 and assigns it to the IdleTimeoutS field.
func (o *SubmitRun) SetIdleTimeoutS(v float64) {
	o.IdleTimeoutS = &v
}

// GetImages returns the Images field value if set, zero value otherwise.
func (o *SubmitRun) GetImages() ImageChoice {
	if o == nil || IsNil(o.Images) {
		var ret ImageChoice
		return ret
	}
	return *o.Images
}

// GetImagesOk returns a tuple with the Images field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetImagesOk() (*ImageChoice, bool) {
	if o == nil || IsNil(o.Images) {
		return nil, false
	}
	return o.Images, true
}

// HasImages returns a boolean if a field has been set.
func (o *SubmitRun) HasImages() bool {
	if o != nil && !IsNil(o.Images) {
		return true
	}

	return false
}

// SetImages gets a reference to the given ImageChoice and assigns it to the Images field.
func (o *SubmitRun) SetImages(v ImageChoice) {
	o.Images = &v
}

// GetOptions returns the Options field value if set, zero value otherwise.
func (o *SubmitRun) GetOptions() CalibrationOptions {
	if o == nil || IsNil(o.Options) {
		var ret CalibrationOptions
		return ret
	}
	return *o.Options
}

// GetOptionsOk returns a tuple with the Options field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetOptionsOk() (*CalibrationOptions, bool) {
	if o == nil || IsNil(o.Options) {
		return nil, false
	}
	return o.Options, true
}

// HasOptions returns a boolean if a field has been set.
func (o *SubmitRun) HasOptions() bool {
	if o != nil && !IsNil(o.Options) {
		return true
	}

	return false
}

// SetOptions gets a reference to the given CalibrationOptions and assigns it to the Options field.
func (o *SubmitRun) SetOptions(v CalibrationOptions) {
	o.Options = &v
}

// GetMode returns the Mode field value if set, zero value otherwise.
func (o *SubmitRun) GetMode() RunMode {
	if o == nil || IsNil(o.Mode) {
		var ret RunMode
		return ret
	}
	return *o.Mode
}

// GetModeOk returns a tuple with the Mode field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetModeOk() (*RunMode, bool) {
	if o == nil || IsNil(o.Mode) {
		return nil, false
	}
	return o.Mode, true
}

// HasMode returns a boolean if a field has been set.
func (o *SubmitRun) HasMode() bool {
	if o != nil && !IsNil(o.Mode) {
		return true
	}

	return false
}

// SetMode gets a reference to the given RunMode and assigns it to the Mode field.
func (o *SubmitRun) SetMode(v RunMode) {
	o.Mode = &v
}

// GetPolicyServer returns the PolicyServer field value if set, zero value otherwise.
func (o *SubmitRun) GetPolicyServer() PolicyServer {
	if o == nil || IsNil(o.PolicyServer) {
		var ret PolicyServer
		return ret
	}
	return *o.PolicyServer
}

// GetPolicyServerOk returns a tuple with the PolicyServer field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *SubmitRun) GetPolicyServerOk() (*PolicyServer, bool) {
	if o == nil || IsNil(o.PolicyServer) {
		return nil, false
	}
	return o.PolicyServer, true
}

// HasPolicyServer returns a boolean if a field has been set.
func (o *SubmitRun) HasPolicyServer() bool {
	if o != nil && !IsNil(o.PolicyServer) {
		return true
	}

	return false
}

// SetPolicyServer gets a reference to the given PolicyServer and assigns it to the PolicyServer field.
func (o *SubmitRun) SetPolicyServer(v PolicyServer) {
	o.PolicyServer = &v
}

func (o SubmitRun) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o SubmitRun) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["benchmark_id"] = o.BenchmarkId
	toSerialize["policy"] = o.Policy
	if !IsNil(o.MaxWorkers) {
		toSerialize["max_workers"] = o.MaxWorkers
	}
	if !IsNil(o.IdleTimeoutS) {
		toSerialize["idle_timeout_s"] = o.IdleTimeoutS
	}
	if !IsNil(o.Images) {
		toSerialize["images"] = o.Images
	}
	if !IsNil(o.Options) {
		toSerialize["options"] = o.Options
	}
	if !IsNil(o.Mode) {
		toSerialize["mode"] = o.Mode
	}
	if !IsNil(o.PolicyServer) {
		toSerialize["policy_server"] = o.PolicyServer
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *SubmitRun) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"benchmark_id",
		"policy",
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

	varSubmitRun := _SubmitRun{}

	err = json.Unmarshal(data, &varSubmitRun)

	if err != nil {
		return err
	}

	*o = SubmitRun(varSubmitRun)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "benchmark_id")
		delete(additionalProperties, "policy")
		delete(additionalProperties, "max_workers")
		delete(additionalProperties, "idle_timeout_s")
		delete(additionalProperties, "images")
		delete(additionalProperties, "options")
		delete(additionalProperties, "mode")
		delete(additionalProperties, "policy_server")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableSubmitRun struct {
	value *SubmitRun
	isSet bool
}

func (v NullableSubmitRun) Get() *SubmitRun {
	return v.value
}

func (v *NullableSubmitRun) Set(val *SubmitRun) {
	v.value = val
	v.isSet = true
}

func (v NullableSubmitRun) IsSet() bool {
	return v.isSet
}

func (v *NullableSubmitRun) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableSubmitRun(val *SubmitRun) *NullableSubmitRun {
	return &NullableSubmitRun{value: val, isSet: true}
}

func (v NullableSubmitRun) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableSubmitRun) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
