// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the Timing type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Timing{}

// Timing Server time of this turn, in seconds.
type Timing struct {
	TotalS float64 `json:"total_s"`
	QueueS float64 `json:"queue_s"`
	SimulateS float64 `json:"simulate_s"`
	RenderS float64 `json:"render_s"`
	// Encoding of images.
	EncodeS float64 `json:"encode_s"`
	AdditionalProperties map[string]interface{}
}

type _Timing Timing

// NewTiming instantiates a new Timing object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewTiming(totalS float64, queueS float64, simulateS float64, renderS float64, encodeS float64) *Timing {
	this := Timing{}
	this.TotalS = totalS
	this.QueueS = queueS
	this.SimulateS = simulateS
	this.RenderS = renderS
	this.EncodeS = encodeS
	return &this
}

// NewTimingWithDefaults instantiates a new Timing object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewTimingWithDefaults() *Timing {
	this := Timing{}
	return &this
}

// GetTotalS returns the TotalS field value
func (o *Timing) GetTotalS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.TotalS
}

// GetTotalSOk returns a tuple with the TotalS field value
// and a boolean to check if the value has been set.
func (o *Timing) GetTotalSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.TotalS, true
}

// SetTotalS sets field value
func (o *Timing) SetTotalS(v float64) {
	o.TotalS = v
}

// GetQueueS returns the QueueS field value
func (o *Timing) GetQueueS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.QueueS
}

// GetQueueSOk returns a tuple with the QueueS field value
// and a boolean to check if the value has been set.
func (o *Timing) GetQueueSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.QueueS, true
}

// SetQueueS sets field value
func (o *Timing) SetQueueS(v float64) {
	o.QueueS = v
}

// GetSimulateS returns the SimulateS field value
func (o *Timing) GetSimulateS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.SimulateS
}

// GetSimulateSOk returns a tuple with the SimulateS field value
// and a boolean to check if the value has been set.
func (o *Timing) GetSimulateSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.SimulateS, true
}

// SetSimulateS sets field value
func (o *Timing) SetSimulateS(v float64) {
	o.SimulateS = v
}

// GetRenderS returns the RenderS field value
func (o *Timing) GetRenderS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.RenderS
}

// GetRenderSOk returns a tuple with the RenderS field value
// and a boolean to check if the value has been set.
func (o *Timing) GetRenderSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.RenderS, true
}

// SetRenderS sets field value
func (o *Timing) SetRenderS(v float64) {
	o.RenderS = v
}

// GetEncodeS returns the EncodeS field value
func (o *Timing) GetEncodeS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.EncodeS
}

// GetEncodeSOk returns a tuple with the EncodeS field value
// and a boolean to check if the value has been set.
func (o *Timing) GetEncodeSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.EncodeS, true
}

// SetEncodeS sets field value
func (o *Timing) SetEncodeS(v float64) {
	o.EncodeS = v
}

func (o Timing) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Timing) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["total_s"] = o.TotalS
	toSerialize["queue_s"] = o.QueueS
	toSerialize["simulate_s"] = o.SimulateS
	toSerialize["render_s"] = o.RenderS
	toSerialize["encode_s"] = o.EncodeS

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Timing) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"total_s",
		"queue_s",
		"simulate_s",
		"render_s",
		"encode_s",
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

	varTiming := _Timing{}

	err = json.Unmarshal(data, &varTiming)

	if err != nil {
		return err
	}

	*o = Timing(varTiming)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "total_s")
		delete(additionalProperties, "queue_s")
		delete(additionalProperties, "simulate_s")
		delete(additionalProperties, "render_s")
		delete(additionalProperties, "encode_s")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableTiming struct {
	value *Timing
	isSet bool
}

func (v NullableTiming) Get() *Timing {
	return v.value
}

func (v *NullableTiming) Set(val *Timing) {
	v.value = val
	v.isSet = true
}

func (v NullableTiming) IsSet() bool {
	return v.isSet
}

func (v *NullableTiming) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableTiming(val *Timing) *NullableTiming {
	return &NullableTiming{value: val, isSet: true}
}

func (v NullableTiming) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableTiming) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
