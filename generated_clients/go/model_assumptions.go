// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
)

// checks if the Assumptions type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Assumptions{}

// Assumptions What the policy takes for granted; refused when the benchmark says otherwise.
type Assumptions struct {
	ControlRateHz *float64 `json:"control_rate_hz,omitempty"`
	Action map[string]Assumption `json:"action,omitempty"`
	State map[string]Assumption `json:"state,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _Assumptions Assumptions

// NewAssumptions instantiates a new Assumptions object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewAssumptions() *Assumptions {
	this := Assumptions{}
	return &this
}

// NewAssumptionsWithDefaults instantiates a new Assumptions object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewAssumptionsWithDefaults() *Assumptions {
	this := Assumptions{}
	return &this
}

// GetControlRateHz returns the ControlRateHz field value if set, zero value otherwise.
func (o *Assumptions) GetControlRateHz() float64 {
	if o == nil || IsNil(o.ControlRateHz) {
		var ret float64
		return ret
	}
	return *o.ControlRateHz
}

// GetControlRateHzOk returns a tuple with the ControlRateHz field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumptions) GetControlRateHzOk() (*float64, bool) {
	if o == nil || IsNil(o.ControlRateHz) {
		return nil, false
	}
	return o.ControlRateHz, true
}

// HasControlRateHz returns a boolean if a field has been set.
func (o *Assumptions) HasControlRateHz() bool {
	if o != nil && !IsNil(o.ControlRateHz) {
		return true
	}

	return false
}

// SetControlRateHz gets a reference to the given float64 and assigns it to the ControlRateHz field.
func (o *Assumptions) SetControlRateHz(v float64) {
	o.ControlRateHz = &v
}

// GetAction returns the Action field value if set, zero value otherwise.
func (o *Assumptions) GetAction() map[string]Assumption {
	if o == nil || IsNil(o.Action) {
		var ret map[string]Assumption
		return ret
	}
	return o.Action
}

// GetActionOk returns a tuple with the Action field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumptions) GetActionOk() (map[string]Assumption, bool) {
	if o == nil || IsNil(o.Action) {
		return map[string]Assumption{}, false
	}
	return o.Action, true
}

// HasAction returns a boolean if a field has been set.
func (o *Assumptions) HasAction() bool {
	if o != nil && !IsNil(o.Action) {
		return true
	}

	return false
}

// SetAction gets a reference to the given map[string]Assumption and assigns it to the Action field.
func (o *Assumptions) SetAction(v map[string]Assumption) {
	o.Action = v
}

// GetState returns the State field value if set, zero value otherwise.
func (o *Assumptions) GetState() map[string]Assumption {
	if o == nil || IsNil(o.State) {
		var ret map[string]Assumption
		return ret
	}
	return o.State
}

// GetStateOk returns a tuple with the State field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumptions) GetStateOk() (map[string]Assumption, bool) {
	if o == nil || IsNil(o.State) {
		return map[string]Assumption{}, false
	}
	return o.State, true
}

// HasState returns a boolean if a field has been set.
func (o *Assumptions) HasState() bool {
	if o != nil && !IsNil(o.State) {
		return true
	}

	return false
}

// SetState gets a reference to the given map[string]Assumption and assigns it to the State field.
func (o *Assumptions) SetState(v map[string]Assumption) {
	o.State = v
}

func (o Assumptions) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Assumptions) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	if !IsNil(o.ControlRateHz) {
		toSerialize["control_rate_hz"] = o.ControlRateHz
	}
	if !IsNil(o.Action) {
		toSerialize["action"] = o.Action
	}
	if !IsNil(o.State) {
		toSerialize["state"] = o.State
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Assumptions) UnmarshalJSON(data []byte) (err error) {
	varAssumptions := _Assumptions{}

	err = json.Unmarshal(data, &varAssumptions)

	if err != nil {
		return err
	}

	*o = Assumptions(varAssumptions)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "control_rate_hz")
		delete(additionalProperties, "action")
		delete(additionalProperties, "state")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableAssumptions struct {
	value *Assumptions
	isSet bool
}

func (v NullableAssumptions) Get() *Assumptions {
	return v.value
}

func (v *NullableAssumptions) Set(val *Assumptions) {
	v.value = val
	v.isSet = true
}

func (v NullableAssumptions) IsSet() bool {
	return v.isSet
}

func (v *NullableAssumptions) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableAssumptions(val *Assumptions) *NullableAssumptions {
	return &NullableAssumptions{value: val, isSet: true}
}

func (v NullableAssumptions) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableAssumptions) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
