// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
)

// checks if the CalibrationOptions type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &CalibrationOptions{}

// CalibrationOptions Only for the benchmark `calibration`, which the submitter shapes.
type CalibrationOptions struct {
	// One entry per episode, in order; one `score` episode when absent.
	Tasks []CalibrationTask `json:"tasks,omitempty"`
	// 10 when absent.
	MaxSteps *int32 `json:"max_steps,omitempty"`
	SuccessRule *SuccessRule `json:"success_rule,omitempty"`
	// 3 when absent.
	MaxAttempts *int32 `json:"max_attempts,omitempty"`
	// 3 when absent.
	MaxFaults *int32 `json:"max_faults,omitempty"`
	// Seconds for which the run stays queued after submit and after resume; 0 when absent.
	QueueS *float64 `json:"queue_s,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _CalibrationOptions CalibrationOptions

// NewCalibrationOptions instantiates a new CalibrationOptions object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewCalibrationOptions() *CalibrationOptions {
	this := CalibrationOptions{}
	return &this
}

// NewCalibrationOptionsWithDefaults instantiates a new CalibrationOptions object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewCalibrationOptionsWithDefaults() *CalibrationOptions {
	this := CalibrationOptions{}
	return &this
}

// GetTasks returns the Tasks field value if set, zero value otherwise.
func (o *CalibrationOptions) GetTasks() []CalibrationTask {
	if o == nil || IsNil(o.Tasks) {
		var ret []CalibrationTask
		return ret
	}
	return o.Tasks
}

// GetTasksOk returns a tuple with the Tasks field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *CalibrationOptions) GetTasksOk() ([]CalibrationTask, bool) {
	if o == nil || IsNil(o.Tasks) {
		return nil, false
	}
	return o.Tasks, true
}

// HasTasks returns a boolean if a field has been set.
func (o *CalibrationOptions) HasTasks() bool {
	if o != nil && !IsNil(o.Tasks) {
		return true
	}

	return false
}

// SetTasks gets a reference to the given []CalibrationTask and assigns it to the Tasks field.
func (o *CalibrationOptions) SetTasks(v []CalibrationTask) {
	o.Tasks = v
}

// GetMaxSteps returns the MaxSteps field value if set, zero value otherwise.
func (o *CalibrationOptions) GetMaxSteps() int32 {
	if o == nil || IsNil(o.MaxSteps) {
		var ret int32
		return ret
	}
	return *o.MaxSteps
}

// GetMaxStepsOk returns a tuple with the MaxSteps field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *CalibrationOptions) GetMaxStepsOk() (*int32, bool) {
	if o == nil || IsNil(o.MaxSteps) {
		return nil, false
	}
	return o.MaxSteps, true
}

// HasMaxSteps returns a boolean if a field has been set.
func (o *CalibrationOptions) HasMaxSteps() bool {
	if o != nil && !IsNil(o.MaxSteps) {
		return true
	}

	return false
}

// SetMaxSteps gets a reference to the given int32 and assigns it to the MaxSteps field.
func (o *CalibrationOptions) SetMaxSteps(v int32) {
	o.MaxSteps = &v
}

// GetSuccessRule returns the SuccessRule field value if set, zero value otherwise.
func (o *CalibrationOptions) GetSuccessRule() SuccessRule {
	if o == nil || IsNil(o.SuccessRule) {
		var ret SuccessRule
		return ret
	}
	return *o.SuccessRule
}

// GetSuccessRuleOk returns a tuple with the SuccessRule field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *CalibrationOptions) GetSuccessRuleOk() (*SuccessRule, bool) {
	if o == nil || IsNil(o.SuccessRule) {
		return nil, false
	}
	return o.SuccessRule, true
}

// HasSuccessRule returns a boolean if a field has been set.
func (o *CalibrationOptions) HasSuccessRule() bool {
	if o != nil && !IsNil(o.SuccessRule) {
		return true
	}

	return false
}

// SetSuccessRule gets a reference to the given SuccessRule and assigns it to the SuccessRule field.
func (o *CalibrationOptions) SetSuccessRule(v SuccessRule) {
	o.SuccessRule = &v
}

// GetMaxAttempts returns the MaxAttempts field value if set, zero value otherwise.
func (o *CalibrationOptions) GetMaxAttempts() int32 {
	if o == nil || IsNil(o.MaxAttempts) {
		var ret int32
		return ret
	}
	return *o.MaxAttempts
}

// GetMaxAttemptsOk returns a tuple with the MaxAttempts field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *CalibrationOptions) GetMaxAttemptsOk() (*int32, bool) {
	if o == nil || IsNil(o.MaxAttempts) {
		return nil, false
	}
	return o.MaxAttempts, true
}

// HasMaxAttempts returns a boolean if a field has been set.
func (o *CalibrationOptions) HasMaxAttempts() bool {
	if o != nil && !IsNil(o.MaxAttempts) {
		return true
	}

	return false
}

// SetMaxAttempts gets a reference to the given int32 and assigns it to the MaxAttempts field.
func (o *CalibrationOptions) SetMaxAttempts(v int32) {
	o.MaxAttempts = &v
}

// GetMaxFaults returns the MaxFaults field value if set, zero value otherwise.
func (o *CalibrationOptions) GetMaxFaults() int32 {
	if o == nil || IsNil(o.MaxFaults) {
		var ret int32
		return ret
	}
	return *o.MaxFaults
}

// GetMaxFaultsOk returns a tuple with the MaxFaults field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *CalibrationOptions) GetMaxFaultsOk() (*int32, bool) {
	if o == nil || IsNil(o.MaxFaults) {
		return nil, false
	}
	return o.MaxFaults, true
}

// HasMaxFaults returns a boolean if a field has been set.
func (o *CalibrationOptions) HasMaxFaults() bool {
	if o != nil && !IsNil(o.MaxFaults) {
		return true
	}

	return false
}

// SetMaxFaults gets a reference to the given int32 and assigns it to the MaxFaults field.
func (o *CalibrationOptions) SetMaxFaults(v int32) {
	o.MaxFaults = &v
}

// GetQueueS returns the QueueS field value if set, zero value otherwise.
func (o *CalibrationOptions) GetQueueS() float64 {
	if o == nil || IsNil(o.QueueS) {
		var ret float64
		return ret
	}
	return *o.QueueS
}

// GetQueueSOk returns a tuple with the QueueS field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *CalibrationOptions) GetQueueSOk() (*float64, bool) {
	if o == nil || IsNil(o.QueueS) {
		return nil, false
	}
	return o.QueueS, true
}

// HasQueueS returns a boolean if a field has been set.
func (o *CalibrationOptions) HasQueueS() bool {
	if o != nil && !IsNil(o.QueueS) {
		return true
	}

	return false
}

// SetQueueS gets a reference to the given float64 and assigns it to the QueueS field.
func (o *CalibrationOptions) SetQueueS(v float64) {
	o.QueueS = &v
}

func (o CalibrationOptions) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o CalibrationOptions) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	if !IsNil(o.Tasks) {
		toSerialize["tasks"] = o.Tasks
	}
	if !IsNil(o.MaxSteps) {
		toSerialize["max_steps"] = o.MaxSteps
	}
	if !IsNil(o.SuccessRule) {
		toSerialize["success_rule"] = o.SuccessRule
	}
	if !IsNil(o.MaxAttempts) {
		toSerialize["max_attempts"] = o.MaxAttempts
	}
	if !IsNil(o.MaxFaults) {
		toSerialize["max_faults"] = o.MaxFaults
	}
	if !IsNil(o.QueueS) {
		toSerialize["queue_s"] = o.QueueS
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *CalibrationOptions) UnmarshalJSON(data []byte) (err error) {
	varCalibrationOptions := _CalibrationOptions{}

	err = json.Unmarshal(data, &varCalibrationOptions)

	if err != nil {
		return err
	}

	*o = CalibrationOptions(varCalibrationOptions)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "tasks")
		delete(additionalProperties, "max_steps")
		delete(additionalProperties, "success_rule")
		delete(additionalProperties, "max_attempts")
		delete(additionalProperties, "max_faults")
		delete(additionalProperties, "queue_s")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableCalibrationOptions struct {
	value *CalibrationOptions
	isSet bool
}

func (v NullableCalibrationOptions) Get() *CalibrationOptions {
	return v.value
}

func (v *NullableCalibrationOptions) Set(val *CalibrationOptions) {
	v.value = val
	v.isSet = true
}

func (v NullableCalibrationOptions) IsSet() bool {
	return v.isSet
}

func (v *NullableCalibrationOptions) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableCalibrationOptions(val *CalibrationOptions) *NullableCalibrationOptions {
	return &NullableCalibrationOptions{value: val, isSet: true}
}

func (v NullableCalibrationOptions) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableCalibrationOptions) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
