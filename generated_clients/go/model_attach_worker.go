// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the AttachWorker type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &AttachWorker{}

// AttachWorker struct for AttachWorker
type AttachWorker struct {
	// Chosen anew for every attachment; repeated only to repeat a lost request.
	AttachKey string `json:"attach_key"`
	// Fence out a live session; false when absent.
	Takeover *bool `json:"takeover,omitempty"`
	Assumes *Assumptions `json:"assumes,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _AttachWorker AttachWorker

// NewAttachWorker instantiates a new AttachWorker object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewAttachWorker(attachKey string) *AttachWorker {
	this := AttachWorker{}
	this.AttachKey = attachKey
	return &this
}

// NewAttachWorkerWithDefaults instantiates a new AttachWorker object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewAttachWorkerWithDefaults() *AttachWorker {
	this := AttachWorker{}
	return &this
}

// GetAttachKey returns the AttachKey field value
func (o *AttachWorker) GetAttachKey() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.AttachKey
}

// GetAttachKeyOk returns a tuple with the AttachKey field value
// and a boolean to check if the value has been set.
func (o *AttachWorker) GetAttachKeyOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.AttachKey, true
}

// SetAttachKey sets field value
func (o *AttachWorker) SetAttachKey(v string) {
	o.AttachKey = v
}

// GetTakeover returns the Takeover field value if set, zero value otherwise.
func (o *AttachWorker) GetTakeover() bool {
	if o == nil || IsNil(o.Takeover) {
		var ret bool
		return ret
	}
	return *o.Takeover
}

// GetTakeoverOk returns a tuple with the Takeover field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *AttachWorker) GetTakeoverOk() (*bool, bool) {
	if o == nil || IsNil(o.Takeover) {
		return nil, false
	}
	return o.Takeover, true
}

// HasTakeover returns a boolean if a field has been set.
func (o *AttachWorker) HasTakeover() bool {
	if o != nil && !IsNil(o.Takeover) {
		return true
	}

	return false
}

// SetTakeover gets a reference to the given bool and assigns it to the Takeover field.
func (o *AttachWorker) SetTakeover(v bool) {
	o.Takeover = &v
}

// GetAssumes returns the Assumes field value if set, zero value otherwise.
func (o *AttachWorker) GetAssumes() Assumptions {
	if o == nil || IsNil(o.Assumes) {
		var ret Assumptions
		return ret
	}
	return *o.Assumes
}

// GetAssumesOk returns a tuple with the Assumes field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *AttachWorker) GetAssumesOk() (*Assumptions, bool) {
	if o == nil || IsNil(o.Assumes) {
		return nil, false
	}
	return o.Assumes, true
}

// HasAssumes returns a boolean if a field has been set.
func (o *AttachWorker) HasAssumes() bool {
	if o != nil && !IsNil(o.Assumes) {
		return true
	}

	return false
}

// SetAssumes gets a reference to the given Assumptions and assigns it to the Assumes field.
func (o *AttachWorker) SetAssumes(v Assumptions) {
	o.Assumes = &v
}

func (o AttachWorker) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o AttachWorker) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["attach_key"] = o.AttachKey
	if !IsNil(o.Takeover) {
		toSerialize["takeover"] = o.Takeover
	}
	if !IsNil(o.Assumes) {
		toSerialize["assumes"] = o.Assumes
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *AttachWorker) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"attach_key",
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

	varAttachWorker := _AttachWorker{}

	err = json.Unmarshal(data, &varAttachWorker)

	if err != nil {
		return err
	}

	*o = AttachWorker(varAttachWorker)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "attach_key")
		delete(additionalProperties, "takeover")
		delete(additionalProperties, "assumes")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableAttachWorker struct {
	value *AttachWorker
	isSet bool
}

func (v NullableAttachWorker) Get() *AttachWorker {
	return v.value
}

func (v *NullableAttachWorker) Set(val *AttachWorker) {
	v.value = val
	v.isSet = true
}

func (v NullableAttachWorker) IsSet() bool {
	return v.isSet
}

func (v *NullableAttachWorker) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableAttachWorker(val *AttachWorker) *NullableAttachWorker {
	return &NullableAttachWorker{value: val, isSet: true}
}

func (v NullableAttachWorker) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableAttachWorker) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
