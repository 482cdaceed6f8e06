// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"time"
	"fmt"
)

// checks if the Lease type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Lease{}

// Lease struct for Lease
type Lease struct {
	ExpiresAt time.Time `json:"expires_at"`
	IdleTimeoutS float64 `json:"idle_timeout_s"`
	AdditionalProperties map[string]interface{}
}

type _Lease Lease

// NewLease instantiates a new Lease object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewLease(expiresAt time.Time, idleTimeoutS float64) *Lease {
	this := Lease{}
	this.ExpiresAt = expiresAt
	this.IdleTimeoutS = idleTimeoutS
	return &this
}

// NewLeaseWithDefaults instantiates a new Lease object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewLeaseWithDefaults() *Lease {
	this := Lease{}
	return &this
}

// GetExpiresAt returns the ExpiresAt field value
func (o *Lease) GetExpiresAt() time.Time {
	if o == nil {
		var ret time.Time
		return ret
	}

	return o.ExpiresAt
}

// GetExpiresAtOk returns a tuple with the ExpiresAt field value
// and a boolean to check if the value has been set.
func (o *Lease) GetExpiresAtOk() (*time.Time, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ExpiresAt, true
}

// SetExpiresAt sets field value
func (o *Lease) SetExpiresAt(v time.Time) {
	o.ExpiresAt = v
}

// GetIdleTimeoutS returns the IdleTimeoutS field value
func (o *Lease) GetIdleTimeoutS() float64 {
	if o == nil {
		var ret float64
		return ret
	}

	return o.IdleTimeoutS
}

// GetIdleTimeoutSOk returns a tuple with the IdleTimeoutS field value
// and a boolean to check if the value has been set.
func (o *Lease) GetIdleTimeoutSOk() (*float64, bool) {
	if o == nil {
		return nil, false
	}
	return &o.IdleTimeoutS, true
}

// SetIdleTimeoutS sets field value
func (o *Lease) SetIdleTimeoutS(v float64) {
	o.IdleTimeoutS = v
}

func (o Lease) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Lease) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["expires_at"] = o.ExpiresAt
	toSerialize["idle_timeout_s"] = o.IdleTimeoutS

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Lease) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"expires_at",
		"idle_timeout_s",
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

	varLease := _Lease{}

	err = json.Unmarshal(data, &varLease)

	if err != nil {
		return err
	}

	*o = Lease(varLease)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "expires_at")
		delete(additionalProperties, "idle_timeout_s")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableLease struct {
	value *Lease
	isSet bool
}

func (v NullableLease) Get() *Lease {
	return v.value
}

func (v *NullableLease) Set(val *Lease) {
	v.value = val
	v.isSet = true
}

func (v NullableLease) IsSet() bool {
	return v.isSet
}

func (v *NullableLease) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableLease(val *Lease) *NullableLease {
	return &NullableLease{value: val, isSet: true}
}

func (v NullableLease) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableLease) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
