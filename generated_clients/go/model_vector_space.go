// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the VectorSpace type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &VectorSpace{}

// VectorSpace One named vector of numbers, with every convention a policy could get wrong.
type VectorSpace struct {
	Size int32 `json:"size"`
	// `rad`, `m`, `1`, or several joined by commas.
	Unit string `json:"unit"`
	Rotation string `json:"rotation" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// `world`, `base`, `tool`, `joint`, or `none`.
	Frame string `json:"frame"`
	// True when the values are increments.
	Relative bool `json:"relative"`
	// The value that means fully open.
	GripperOpen *float64 `json:"gripper_open,omitempty"`
	Minimum []float64 `json:"minimum,omitempty"`
	Maximum []float64 `json:"maximum,omitempty"`
	OutOfRange string `json:"out_of_range" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	// What the numbers are.
	Description *string `json:"description,omitempty"`
	// The tasks that have this entry; all of them when absent.
	Tasks []string `json:"tasks,omitempty"`
	AdditionalProperties map[string]interface{}
}

type _VectorSpace VectorSpace

// NewVectorSpace instantiates a new VectorSpace object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewVectorSpace(size int32, unit string, rotation string, frame string, relative bool, outOfRange string) *VectorSpace {
	this := VectorSpace{}
	this.Size = size
	this.Unit = unit
	this.Rotation = rotation
	this.Frame = frame
	this.Relative = relative
	this.OutOfRange = outOfRange
	return &this
}

// NewVectorSpaceWithDefaults instantiates a new VectorSpace object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewVectorSpaceWithDefaults() *VectorSpace {
	this := VectorSpace{}
	return &this
}

// GetSize returns the Size field value
func (o *VectorSpace) GetSize() int32 {
	if o == nil {
		var ret int32
		return ret
	}

	return o.Size
}

// GetSizeOk returns a tuple with the Size field value
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetSizeOk() (*int32, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Size, true
}

// SetSize sets field value
func (o *VectorSpace) SetSize(v int32) {
	o.Size = v
}

// GetUnit returns the Unit field value
func (o *VectorSpace) GetUnit() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Unit
}

// GetUnitOk returns a tuple with the Unit field value
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetUnitOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Unit, true
}

// SetUnit sets field value
func (o *VectorSpace) SetUnit(v string) {
	o.Unit = v
}

// GetRotation returns the Rotation field value
func (o *VectorSpace) GetRotation() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Rotation
}

// GetRotationOk returns a tuple with the Rotation field value
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetRotationOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Rotation, true
}

// SetRotation sets field value
func (o *VectorSpace) SetRotation(v string) {
	o.Rotation = v
}

// GetFrame returns the Frame field value
func (o *VectorSpace) GetFrame() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Frame
}

// GetFrameOk returns a tuple with the Frame field value
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetFrameOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Frame, true
}

// SetFrame sets field value
func (o *VectorSpace) SetFrame(v string) {
	o.Frame = v
}

// GetRelative returns the Relative field value
func (o *VectorSpace) GetRelative() bool {
	if o == nil {
		var ret bool
		return ret
	}

	return o.Relative
}

// GetRelativeOk returns a tuple with the Relative field value
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetRelativeOk() (*bool, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Relative, true
}

// SetRelative sets field value
func (o *VectorSpace) SetRelative(v bool) {
	o.Relative = v
}

// GetGripperOpen returns the GripperOpen field value if set, zero value otherwise.
func (o *VectorSpace) GetGripperOpen() float64 {
	if o == nil || IsNil(o.GripperOpen) {
		var ret float64
		return ret
	}
	return *o.GripperOpen
}

// GetGripperOpenOk returns a tuple with the GripperOpen field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetGripperOpenOk() (*float64, bool) {
	if o == nil || IsNil(o.GripperOpen) {
		return nil, false
	}
	return o.GripperOpen, true
}

// HasGripperOpen returns a boolean if a field has been set.
func (o *VectorSpace) HasGripperOpen() bool {
	if o != nil && !IsNil(o.GripperOpen) {
		return true
	}

	return false
}

// SetGripperOpen gets a reference to the given float64 and assigns it to the GripperOpen field.
func (o *VectorSpace) SetGripperOpen(v float64) {
	o.GripperOpen = &v
}

// GetMinimum returns the Minimum field value if set, zero value otherwise.
func (o *VectorSpace) GetMinimum() []float64 {
	if o == nil || IsNil(o.Minimum) {
		var ret []float64
		return ret
	}
	return o.Minimum
}

// GetMinimumOk returns a tuple with the Minimum field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetMinimumOk() ([]float64, bool) {
	if o == nil || IsNil(o.Minimum) {
		return nil, false
	}
	return o.Minimum, true
}

// HasMinimum returns a boolean if a field has been set.
func (o *VectorSpace) HasMinimum() bool {
	if o != nil && !IsNil(o.Minimum) {
		return true
	}

	return false
}

// SetMinimum gets a reference to the given []float64 and assigns it to the Minimum field.
func (o *VectorSpace) SetMinimum(v []float64) {
	o.Minimum = v
}

// GetMaximum returns the Maximum field value if set, zero value otherwise.
func (o *VectorSpace) GetMaximum() []float64 {
	if o == nil || IsNil(o.Maximum) {
		var ret []float64
		return ret
	}
	return o.Maximum
}

// GetMaximumOk returns a tuple with the Maximum field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetMaximumOk() ([]float64, bool) {
	if o == nil || IsNil(o.Maximum) {
		return nil, false
	}
	return o.Maximum, true
}

// HasMaximum returns a boolean if a field has been set.
func (o *VectorSpace) HasMaximum() bool {
	if o != nil && !IsNil(o.Maximum) {
		return true
	}

	return false
}

// SetMaximum gets a reference to the given []float64 and assigns it to the Maximum field.
func (o *VectorSpace) SetMaximum(v []float64) {
	o.Maximum = v
}

// GetOutOfRange returns the OutOfRange field value
func (o *VectorSpace) GetOutOfRange() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.OutOfRange
}

// GetOutOfRangeOk returns a tuple with the OutOfRange field value
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetOutOfRangeOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.OutOfRange, true
}

// SetOutOfRange sets field value
func (o *VectorSpace) SetOutOfRange(v string) {
	o.OutOfRange = v
}

// GetDescription returns the Description field value if set, zero value otherwise.
func (o *VectorSpace) GetDescription() string {
	if o == nil || IsNil(o.Description) {
		var ret string
		return ret
	}
	return *o.Description
}

// GetDescriptionOk returns a tuple with the Description field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetDescriptionOk() (*string, bool) {
	if o == nil || IsNil(o.Description) {
		return nil, false
	}
	return o.Description, true
}

// HasDescription returns a boolean if a field has been set.
func (o *VectorSpace) HasDescription() bool {
	if o != nil && !IsNil(o.Description) {
		return true
	}

	return false
}

// SetDescription gets a reference to the given string and assigns it to the Description field.
func (o *VectorSpace) SetDescription(v string) {
	o.Description = &v
}

// GetTasks returns the Tasks field value if set, zero value otherwise.
func (o *VectorSpace) GetTasks() []string {
	if o == nil || IsNil(o.Tasks) {
		var ret []string
		return ret
	}
	return o.Tasks
}

// GetTasksOk returns a tuple with the Tasks field value if set, nil otherwise
// and a boolean to check if the value has been set.
func (o *VectorSpace) GetTasksOk() ([]string, bool) {
	if o == nil || IsNil(o.Tasks) {
		return nil, false
	}
	return o.Tasks, true
}

// HasTasks returns a boolean if a field has been set.
func (o *VectorSpace) HasTasks() bool {
	if o != nil && !IsNil(o.Tasks) {
		return true
	}

	return false
}

// SetTasks gets a reference to the given []string and assigns it to the Tasks field.
func (o *VectorSpace) SetTasks(v []string) {
	o.Tasks = v
}

func (o VectorSpace) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o VectorSpace) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["size"] = o.Size
	toSerialize["unit"] = o.Unit
	toSerialize["rotation"] = o.Rotation
	toSerialize["frame"] = o.Frame
	toSerialize["relative"] = o.Relative
	if !IsNil(o.GripperOpen) {
		toSerialize["gripper_open"] = o.GripperOpen
	}
	if !IsNil(o.Minimum) {
		toSerialize["minimum"] = o.Minimum
	}
	if !IsNil(o.Maximum) {
		toSerialize["maximum"] = o.Maximum
	}
	toSerialize["out_of_range"] = o.OutOfRange
	if !IsNil(o.Description) {
		toSerialize["description"] = o.Description
	}
	if !IsNil(o.Tasks) {
		toSerialize["tasks"] = o.Tasks
	}

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *VectorSpace) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"size",
		"unit",
		"rotation",
		"frame",
		"relative",
		"out_of_range",
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

	varVectorSpace := _VectorSpace{}

	err = json.Unmarshal(data, &varVectorSpace)

	if err != nil {
		return err
	}

	*o = VectorSpace(varVectorSpace)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "size")
		delete(additionalProperties, "unit")
		delete(additionalProperties, "rotation")
		delete(additionalProperties, "frame")
		delete(additionalProperties, "relative")
		delete(additionalProperties, "gripper_open")
		delete(additionalProperties, "minimum")
		delete(additionalProperties, "maximum")
		delete(additionalProperties, "out_of_range")
		delete(additionalProperties, "description")
		delete(additionalProperties, "tasks")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableVectorSpace struct {
	value *VectorSpace
	isSet bool
}

func (v NullableVectorSpace) Get() *VectorSpace {
	return v.value
}

func (v *NullableVectorSpace) Set(val *VectorSpace) {
	v.value = val
	v.isSet = true
}

func (v NullableVectorSpace) IsSet() bool {
	return v.isSet
}

func (v *NullableVectorSpace) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableVectorSpace(val *VectorSpace) *NullableVectorSpace {
	return &NullableVectorSpace{value: val, isSet: true}
}

func (v NullableVectorSpace) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableVectorSpace) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
