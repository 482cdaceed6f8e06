// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
)

// checks if the Assumption type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Assumption{}

// Assumption struct for Assumption
type Assumption struct {
	Size *int32 `json:"size,omitempty"`
	Unit *string `json:"unit,omitempty"`
	Rotation *string `json:"rotation,omitempty" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Frame *string `json:"frame,omitempty"`
	Relative *bool `json:"relative,omitempty"`
	GripperOpen *float64 `json:"gripper_open,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _Assumption Assumption

// NewAssumption instantiates a new Assumption object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewAssumption() *Assumption {
	this := Assumption{}
	return &this
}

// NewAssumptionWithDefaults instantiates a new Assumption object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewAssumptionWithDefaults() *Assumption {
	this := Assumption{}
	return &this
}

// GetSize returns the Size field value if set, zero value otherwise.
func (o *Assumption) GetSize() int32 {
	if o == nil || IsNil(o.Size) {
		var ret int32
		return ret
	}
	return *o.Size
}

// GetSizeOk returns a tuple with the Size field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumption) GetSizeOk() (*int32, bool) {
	if o == nil || IsNil(o.Size) {
		return nil, false
	}
	return o.Size, true
}

// HasSize returns a boolean if a field has been set.
func (o *Assumption) HasSize() bool {
	if o != nil && !IsNil(o.Size) {
		return true
	}

	return false
}

// SetSize gets a reference to the given int32 and assigns it to the Size field.
func (o *Assumption) SetSize(v int32) {
	o.Size = &v
}

// GetUnit returns the Unit field value if set, zero value otherwise.
func (o *Assumption) GetUnit() string {
	if o == nil || IsNil(o.Unit) {
		var ret string
		return ret
	}
	return *o.Unit
}

// GetUnitOk returns a tuple with the Unit field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumption) GetUnitOk() (*string, bool) {
	if o == nil || IsNil(o.Unit) {
		return nil, false
	}
	return o.Unit, true
}

// HasUnit returns a boolean if a field has been set.
func (o *Assumption) HasUnit() bool {
	if o != nil && !IsNil(o.Unit) {
		return true
	}

	return false
}

// SetUnit gets a reference to the given string and assigns it to the Unit field.
func (o *Assumption) SetUnit(v string) {
	o.Unit = &v
}

// GetRotation returns the Rotation field value if set, zero value otherwise.
func (o *Assumption) GetRotation() string {
	if o == nil || IsNil(o.Rotation) {
		var ret string
		return ret
	}
	return *o.Rotation
}

// GetRotationOk returns a tuple with the Rotation field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumption) GetRotationOk() (*string, bool) {
	if o == nil || IsNil(o.Rotation) {
		return nil, false
	}
	return o.Rotation, true
}

// HasRotation returns a boolean if a field has been set.
func (o *Assumption) HasRotation() bool {
	if o != nil && !IsNil(o.Rotation) {
		return true
	}

	return false
}

// SetRotation gets a reference to the given string and assigns it to the Rotation field.
func (o *Assumption) SetRotation(v string) {
	o.Rotation = &v
}

// GetFrame returns the Frame field value if set, zero value otherwise.
func (o *Assumption) GetFrame() string {
	if o == nil || IsNil(o.Frame) {
		var ret string
		return ret
	}
	return *o.Frame
}

// GetFrameOk returns a tuple with the Frame field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumption) GetFrameOk() (*string, bool) {
	if o == nil || IsNil(o.Frame) {
		return nil, false
	}
	return o.Frame, true
}

// HasFrame returns a boolean if a field has been set.
func (o *Assumption) HasFrame() bool {
	if o != nil && !IsNil(o.Frame) {
		return true
	}

	return false
}

// SetFrame gets a reference to the given string and assigns it to the Frame field.
func (o *Assumption) SetFrame(v string) {
	o.Frame = &v
}

// GetRelative returns the Relative field value if set, zero value otherwise.
func (o *Assumption) GetRelative() bool {
	if o == nil || IsNil(o.Relative) {
		var ret bool
		return ret
	}
	return *o.Relative
}

// GetRelativeOk returns a tuple with the Relative field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumption) GetRelativeOk() (*bool, bool) {
	if o == nil || IsNil(o.Relative) {
		return nil, false
	}
	return o.Relative, true
}

// HasRelative returns a boolean if a field has been set.
func (o *Assumption) HasRelative() bool {
	if o != nil && !IsNil(o.Relative) {
		return true
	}

	return false
}

// SetRelative gets a reference to the given bool and assigns it to the Relative field.
func (o *Assumption) SetRelative(v bool) {
	o.Relative = &v
}

// GetGripperOpen returns the GripperOpen field value if set, zero value otherwise.
func (o *Assumption) GetGripperOpen() float64 {
	if o == nil || IsNil(o.GripperOpen) {
		var ret float64
		return ret
	}
	return *o.GripperOpen
}

// GetGripperOpenOk returns a tuple with the GripperOpen field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *Assumption) GetGripperOpenOk() (*float64, bool) {
	if o == nil || IsNil(o.GripperOpen) {
		return nil, false
	}
	return o.GripperOpen, true
}

// HasGripperOpen returns a boolean if a field has been set.
func (o *Assumption) HasGripperOpen() bool {
	if o != nil && !IsNil(o.GripperOpen) {
		return true
	}

	return false
}

// SetGripperOpen gets a reference to the given float64 and assigns it to the GripperOpen field.
func (o *Assumption) SetGripperOpen(v float64) {
	o.GripperOpen = &v
}

func (o Assumption) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Assumption) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	if !IsNil(o.Size) {
		toSerialize["size"] = o.Size
	}
	if !IsNil(o.Unit) {
		toSerialize["unit"] = o.Unit
	}
	if !IsNil(o.Rotation) {
		toSerialize["rotation"] = o.Rotation
	}
	if !IsNil(o.Frame) {
		toSerialize["frame"] = o.Frame
	}
	if !IsNil(o.Relative) {
		toSerialize["relative"] = o.Relative
	}
	if !IsNil(o.GripperOpen) {
		toSerialize["gripper_open"] = o.GripperOpen
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Assumption) UnmarshalJSON(data []byte) (err error) {
	varAssumption := _Assumption{}

	err = json.Unmarshal(data, &varAssumption)

	if err != nil {
		return err
	}

	*o = Assumption(varAssumption)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "size")
		delete(additionalProperties, "unit")
		delete(additionalProperties, "rotation")
		delete(additionalProperties, "frame")
		delete(additionalProperties, "relative")
		delete(additionalProperties, "gripper_open")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableAssumption struct {
	value *Assumption
	isSet bool
}

func (v NullableAssumption) Get() *Assumption {
	return v.value
}

func (v *NullableAssumption) Set(val *Assumption) {
	v.value = val
	v.isSet = true
}

func (v NullableAssumption) IsSet() bool {
	return v.isSet
}

func (v *NullableAssumption) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableAssumption(val *Assumption) *NullableAssumption {
	return &NullableAssumption{value: val, isSet: true}
}

func (v NullableAssumption) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableAssumption) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
