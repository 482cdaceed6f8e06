// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Problem type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Problem{}

// Problem RFC 9457, with what a client needs to decide on a retry.
type Problem struct {
	Type string `json:"type"`
	Title string `json:"title"`
	Status int32 `json:"status"`
	// What happened and what to do about it.
	Detail string `json:"detail"`
	// One of x-problems, or one of a later version.
	Code string `json:"code"`
	// Whether the same request can succeed later.
	Retryable bool `json:"retryable"`
	SideEffects SideEffects `json:"side_effects"`
	Errors []ProblemItem `json:"errors,omitempty"`
	// Id of the rule that was enforced.
	Requirement *string `json:"requirement,omitempty"`
	State *RunState `json:"state,omitempty"`
	ExpectedSeq *int64 `json:"expected_seq,omitempty"`
	// What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
	EndedBy *string `json:"ended_by,omitempty" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	AdditionalProperties map[string]interface{}
}

type _Problem Problem

// NewProblem instantiates a new Problem object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewProblem(type_ string, title string, status int32, detail string, code string, retryable bool, sideEffects SideEffects) *Problem {
	this := Problem{}
	this.Type = type_
	this.Title = title
	this.Status = status
	this.Detail = detail
	this.Code = code
	this.Retryable = retryable
	this.SideEffects = sideEffects
	return &this
}

// NewProblemWithDefaults instantiates a new Problem object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewProblemWithDefaults() *Problem {
	this := Problem{}
	return &this
}

// GetType returns the Type field value
func (o *Problem) GetType() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Type
}

// GetTypeOk returns a tuple with the Type field value
// and a boolean to check if the value has been set.
func (o *Problem) GetTypeOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Type, true
}

// SetType sets field value
func (o *Problem) SetType(v string) {
	o.Type = v
}

// GetTitle returns the Title field value
func (o *Problem) GetTitle() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Title
}

// GetTitleOk returns a tuple with the Title field value
// and a boolean to check if the value has been set.
func (o *Problem) GetTitleOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Title, true
}

// SetTitle sets field value
func (o *Problem) SetTitle(v string) {
	o.Title = v
}

// GetStatus returns the Status field value
func (o *Problem) GetStatus() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Status
}

// GetStatusOk returns a tuple with the Status field value
// and a boolean to check if the value has been set.
func (o *Problem) GetStatusOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Status, true
}

// SetStatus sets field value
func (o *Problem) SetStatus(v int32) {
	o.Status = v
}

// GetDetail returns the Detail field value
func (o *Problem) GetDetail() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Detail
}

// GetDetailOk returns a tuple with the Detail field value
// and a boolean to check if the value has been set.
func (o *Problem) GetDetailOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Detail, true
}

// SetDetail sets field value
func (o *Problem) SetDetail(v string) {
	o.Detail = v
}

// GetCode returns the Code field value
func (o *Problem) GetCode() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Code
}

// GetCodeOk returns a tuple with the Code field value
// and a boolean to check if the value has been set.
func (o *Problem) GetCodeOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Code, true
}

// SetCode sets field value
func (o *Problem) SetCode(v string) {
	o.Code = v
}

// GetRetryable returns the Retryable field value
func (o *Problem) GetRetryable() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Retryable
}

// GetRetryableOk returns a tuple with the Retryable field value
// and a boolean to check if the value has been set.
func (o *Problem) GetRetryableOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Retryable, true
}

// SetRetryable sets field value
func (o *Problem) SetRetryable(v bool) {
	o.Retryable = v
}

// GetSideEffects returns the SideEffects field value
func (o *Problem) GetSideEffects() SideEffects {
	if o == nil {
		var ret SideEffects
		return ret
	}

	return o.SideEffects
}

// GetSideEffectsOk returns a tuple with the SideEffects field value
// and a boolean to check if the value has been set.
func (o *Problem) GetSideEffectsOk() (*SideEffects, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SideEffects, true
}

// SetSideEffects sets field value
func (o *Problem) SetSideEffects(v SideEffects) {
	o.SideEffects = v
}

// GetErrors returns the Errors field value if set, zero value otherwise.
func (o *Problem) GetErrors() []ProblemItem {
	if o == nil || IsNil(o.Errors) {
		var ret []ProblemItem
		return ret
	}
	return o.Errors
}

// GetErrorsOk returns a tuple with the Errors field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Problem) GetErrorsOk() ([]ProblemItem, bool) {
	if o == nil || IsNil(o.Errors) {
		return nil, false
	}
	return o.Errors, true
}

// HasErrors returns a boolean if a field has been set.
func (o *Problem) HasErrors() bool {
	if o != nil && !IsNil(o.Errors) {
		return true
	}

	return false
}

// SetErrors gets a reference to the given []ProblemItem and assigns it to the Errors field.
func (o *Problem) SetErrors(v []ProblemItem) {
	o.Errors = v
}

// GetRequirement returns the Requirement field value if set, zero value otherwise.
func (o *Problem) GetRequirement() string {
	if o == nil || IsNil(o.Requirement) {
		var ret string
		return ret
	}
	return *o.Requirement
}

// GetRequirementOk returns a tuple with the Requirement field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Problem) GetRequirementOk() (*string, bool) {
	if o == nil || IsNil(o.Requirement) {
		return nil, false
	}
	return o.Requirement, true
}

// HasRequirement returns a boolean if a field has been set.
func (o *Problem) HasRequirement() bool {
	if o != nil && !IsNil(o.Requirement) {
		return true
	}

	return false
}

// SetRequirement gets a reference to the given string and assigns it to the Requirement field.
func (o *Problem) SetRequirement(v string) {
	o.Requirement = &v
}

// GetState returns the State field value if set, zero value otherwise.
func (o *Problem) GetState() RunState {
	if o == nil || IsNil(o.State) {
		var ret RunState
		return ret
	}
	return *o.State
}

// GetStateOk returns a tuple with the State field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Problem) GetStateOk() (*RunState, bool) {
	if o == nil || IsNil(o.State) {
		return nil, false
	}
	return o.State, true
}

// HasState returns a boolean if a field has been set.
func (o *Problem) HasState() bool {
	if o != nil && !IsNil(o.State) {
		return true
	}

	return false
}

// SetState gets a reference to the given RunState and assigns it to the State field.
func (o *Problem) SetState(v RunState) {
	o.State = &v
}

// GetExpectedSeq returns the ExpectedSeq field value if set, zero value otherwise.
func (o *Problem) GetExpectedSeq() int64 {
	if o == nil || IsNil(o.ExpectedSeq) {
		var ret int64
		return ret
	}
	return *o.ExpectedSeq
}

// GetExpectedSeqOk returns a tuple with the ExpectedSeq field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Problem) GetExpectedSeqOk() (*int64, bool) {
	if o == nil || IsNil(o.ExpectedSeq) {
		return nil, false
	}
	return o.ExpectedSeq, true
}

// HasExpectedSeq returns a boolean if a field has been set.
func (o *Problem) HasExpectedSeq() bool {
	if o != nil && !IsNil(o.ExpectedSeq) {
		return true
	}

	return false
}

// SetExpectedSeq gets a reference to the given int64 and assigns it to the ExpectedSeq field.
func (o *Problem) SetExpectedSeq(v int64) {
	o.ExpectedSeq = &v
}

// GetEndedBy returns the EndedBy field value if set, zero value otherwise.
func (o *Problem) GetEndedBy() string {
	if o == nil || IsNil(o.EndedBy) {
		var ret string
		return ret
	}
	return *o.EndedBy
}

// GetEndedByOk returns a tuple with the EndedBy field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Problem) GetEndedByOk() (*string, bool) {
	if o == nil || IsNil(o.EndedBy) {
		return nil, false
	}
	return o.EndedBy, true
}

// HasEndedBy returns a boolean if a field has been set.
func (o *Problem) HasEndedBy() bool {
	if o != nil && !IsNil(o.EndedBy) {
		return true
	}

	return false
}

// SetEndedBy gets a reference to the given string and assigns it to the EndedBy field.
func (o *Problem) SetEndedBy(v string) {
	o.EndedBy = &v
}

func (o Problem) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Problem) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["type"] = o.Type
	toSerialize["title"] = o.Title
	toSerialize["status"] = o.Status
	toSerialize["detail"] = o.Detail
	toSerialize["code"] = o.Code
	toSerialize["retryable"] = o.Retryable
	toSerialize["side_effects"] = o.SideEffects
	if !IsNil(o.Errors) {
		toSerialize["errors"] = o.Errors
	}
	if !IsNil(o.Requirement) {
		toSerialize["requirement"] = o.Requirement
	}
	if !IsNil(o.State) {
		toSerialize["state"] = o.State
	}
	if !IsNil(o.ExpectedSeq) {
		toSerialize["expected_seq"] = o.ExpectedSeq
	}
	if !IsNil(o.EndedBy) {
		toSerialize["ended_by"] = o.EndedBy
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Problem) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"type",
		"title",
		"status",
		"detail",
		"code",
		"retryable",
		"side_effects",
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

	varProblem := _Problem{}

	err = json.Unmarshal(data, &varProblem)

	if err != nil {
		return err
	}

	*o = Problem(varProblem)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "type")
		delete(additionalProperties, "title")
		delete(additionalProperties, "status")
		delete(additionalProperties, "detail")
		delete(additionalProperties, "code")
		delete(additionalProperties, "retryable")
		delete(additionalProperties, "side_effects")
		delete(additionalProperties, "errors")
		delete(additionalProperties, "requirement")
		delete(additionalProperties, "state")
		delete(additionalProperties, "expected_seq")
		delete(additionalProperties, "ended_by")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableProblem struct {
	value *Problem
	isSet bool
}

func (v NullableProblem) Get() *Problem {
	return v.value
}

func (v *NullableProblem) Set(val *Problem) {
	v.value = val
	v.isSet = true
}

func (v NullableProblem) IsSet() bool {
	return v.isSet
}

func (v *NullableProblem) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableProblem(val *Problem) *NullableProblem {
	return &NullableProblem{value: val, isSet: true}
}

func (v NullableProblem) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableProblem) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
