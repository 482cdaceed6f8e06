// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"time"
	"fmt"
)

// checks if the Service type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &Service{}

// Service What a server says of itself before anyone authenticates.
type Service struct {
	Name string `json:"name"`
	// Version of the server software.
	Version string `json:"version"`
	Protocol ProtocolRange `json:"protocol"`
	// Parts of the protocol offered; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them, and its report says that they were not verified.
	Profiles []string `json:"profiles"`
	Limits Limits `json:"limits"`
	// Media types of the data plane.
	Encodings []string `json:"encodings"`
	ImageCodecs []string `json:"image_codecs"`
	// The server's clock, UTC.
	ServerTime time.Time `json:"server_time"`
	AdditionalProperties map[string]interface{}
}

type _Service Service

// NewService instantiates a new Service object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewService(name string, version string, protocol ProtocolRange, profiles []string, limits Limits, encodings []string, imageCodecs []string, serverTime time.Time) *Service {
	this := Service{}
	this.Name = name
	this.Version = version
	this.Protocol = protocol
	this.Profiles = profiles
	this.Limits = limits
	this.Encodings = encodings
	this.ImageCodecs = imageCodecs
	this.ServerTime = serverTime
	return &this
}

// NewServiceWithDefaults instantiates a new Service object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewServiceWithDefaults() *Service {
	this := Service{}
	return &this
}

// GetName returns the Name field value
func (o *Service) GetName() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Name
}

// GetNameOk returns a tuple with the Name field value
// and a boolean to check if the value has been set.
func (o *Service) GetNameOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Name, true
}

// SetName sets field value
func (o *Service) SetName(v string) {
	o.Name = v
}

// GetVersion returns the Version field value
func (o *Service) GetVersion() string {
	if o == nil {
		var ret string
		return ret
	}

	return o.Version
}

// GetVersionOk returns a tuple with the Version field value
// and a boolean to check if the value has been set.
func (o *Service) GetVersionOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Version, true
}

// SetVersion sets field value
func (o *Service) SetVersion(v string) {
	o.Version = v
}

// GetProtocol returns the Protocol field value
func (o *Service) GetProtocol() ProtocolRange {
	if o == nil {
		var ret ProtocolRange
		return ret
	}

	return o.Protocol
}

// GetProtocolOk returns a tuple with the Protocol field value
// and a boolean to check if the value has been set.
func (o *Service) GetProtocolOk() (*ProtocolRange, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Protocol, true
}

// SetProtocol sets field value
func (o *Service) SetProtocol(v ProtocolRange) {
	o.Protocol = v
}

// GetProfiles returns the Profiles field value
func (o *Service) GetProfiles() []string {
	if o == nil {
		var ret []string
		return ret
	}

	return o.Profiles
}

// GetProfilesOk returns a tuple with the Profiles field value
// and a boolean to check if the value has been set.
func (o *Service) GetProfilesOk() ([]string, bool) {
	if o == nil {
		return nil, false
	}
	return o.Profiles, true
}

// SetProfiles sets field value
func (o *Service) SetProfiles(v []string) {
	o.Profiles = v
}

// GetLimits returns the Limits field value
func (o *Service) GetLimits() Limits {
	if o == nil {
		var ret Limits
		return ret
	}

	return o.Limits
}

// GetLimitsOk returns a tuple with the Limits field value
// and a boolean to check if the value has been set.
func (o *Service) GetLimitsOk() (*Limits, bool) {
	if o == nil {
		return nil, false
	}
	return &o.Limits, true
}

// SetLimits sets field value
func (o *Service) SetLimits(v Limits) {
	o.Limits = v
}

// GetEncodings returns the Encodings field value
func (o *Service) GetEncodings() []string {
	if o == nil {
		var ret []string
		return ret
	}

	return o.Encodings
}

// GetEncodingsOk returns a tuple with the Encodings field value
// and a boolean to check if the value has been set.
func (o *Service) GetEncodingsOk() ([]string, bool) {
	if o == nil {
		return nil, false
	}
	return o.Encodings, true
}

// SetEncodings sets field value
func (o *Service) SetEncodings(v []string) {
	o.Encodings = v
}

// GetImageCodecs returns the ImageCodecs field value
func (o *Service) GetImageCodecs() []string {
	if o == nil {
		var ret []string
		return ret
	}

	return o.ImageCodecs
}

// GetImageCodecsOk returns a tuple with the ImageCodecs field value
// and a boolean to check if the value has been set.
func (o *Service) GetImageCodecsOk() ([]string, bool) {
	if o == nil {
		return nil, false
	}
	return o.ImageCodecs, true
}

// SetImageCodecs sets field value
func (o *Service) SetImageCodecs(v []string) {
	o.ImageCodecs = v
}

// GetServerTime returns the ServerTime field value
func (o *Service) GetServerTime() time.Time {
	if o == nil {
		var ret time.Time
		return ret
	}

	return o.ServerTime
}

// GetServerTimeOk returns a tuple with the ServerTime field value
// and a boolean to check if the value has been set.
func (o *Service) GetServerTimeOk() (*time.Time, bool) {
	if o == nil {
		return nil, false
	}
	return &o.ServerTime, true
}

// SetServerTime sets field value
func (o *Service) SetServerTime(v time.Time) {
	o.ServerTime = v
}

func (o Service) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o Service) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["name"] = o.Name
	toSerialize["version"] = o.Version
	toSerialize["protocol"] = o.Protocol
	toSerialize["profiles"] = o.Profiles
	toSerialize["limits"] = o.Limits
	toSerialize["encodings"] = o.Encodings
	toSerialize["image_codecs"] = o.ImageCodecs
	toSerialize["server_time"] = o.ServerTime

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *Service) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"name",
		"version",
		"protocol",
		"profiles",
		"limits",
		"encodings",
		"image_codecs",
		"server_time",
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

	varService := _Service{}

	err = json.Unmarshal(data, &varService)

	if err != nil {
		return err
	}

	*o = Service(varService)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "name")
		delete(additionalProperties, "version")
		delete(additionalProperties, "protocol")
		delete(additionalProperties, "profiles")
		delete(additionalProperties, "limits")
		delete(additionalProperties, "encodings")
		delete(additionalProperties, "image_codecs")
		delete(additionalProperties, "server_time")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableService struct {
	value *Service
	isSet bool
}

func (v NullableService) Get() *Service {
	return v.value
}

func (v *NullableService) Set(val *Service) {
	v.value = val
	v.isSet = true
}

func (v NullableService) IsSet() bool {
	return v.isSet
}

func (v *NullableService) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableService(val *Service) *NullableService {
	return &NullableService{value: val, isSet: true}
}

func (v NullableService) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableService) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
