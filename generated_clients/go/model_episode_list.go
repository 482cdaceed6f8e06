// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

import (
	"encoding/json"
	"fmt"
)

// checks if the EpisodeList type satisfies the MappedNullable interface at compile time
var _ MappedNullable = &EpisodeList{}

// EpisodeList struct for EpisodeList
type EpisodeList struct {
	Episodes []Episode `json:"episodes"`
	NextCursor NullableString `json:"next_cursor"`
	AdditionalProperties map[string]interface{}
}

type _EpisodeList EpisodeList

// NewEpisodeList instantiates a new EpisodeList object
// This constructor will assign default values to properties that have it defined,
// and makes sure properties required by API are set, but the set of arguments
// will change when the set of required properties is changed
func NewEpisodeList(episodes []Episode, nextCursor NullableString) *EpisodeList {
	this := EpisodeList{}
	this.Episodes = episodes
	this.NextCursor = nextCursor
	return &this
}

// NewEpisodeListWithDefaults instantiates a new EpisodeList object
// This constructor will only assign default values to properties that have it defined,
// but it doesn't guarantee that properties required by API are set
func NewEpisodeListWithDefaults() *EpisodeList {
	this := EpisodeList{}
	return &this
}

// GetEpisodes returns the Episodes field value
func (o *EpisodeList) GetEpisodes() []Episode {
	if o == nil {
		var ret []Episode
		return ret
	}

	return o.Episodes
}

// GetEpisodesOk returns a tuple with the Episodes field value
// and a boolean to check if the value has been set.
func (o *EpisodeList) GetEpisodesOk() ([]Episode, bool) {
	if o == nil {
		return nil, false
	}
	return o.Episodes, true
}

// SetEpisodes sets field value
func (o *EpisodeList) SetEpisodes(v []Episode) {
	o.Episodes = v
}

// GetNextCursor returns the NextCursor field value
// If the value is explicit nil, the zero value for string will be returned
func (o *EpisodeList) GetNextCursor() string {
	if o == nil || o.NextCursor.Get() == nil {
		var ret string
		return ret
	}

	return *o.NextCursor.Get()
}

// GetNextCursorOk returns a tuple with the NextCursor field value
// and a boolean to check if the value has been set.
// NOTE: If the value is an explicit nil, `nil, true` will be returned
func (o *EpisodeList) GetNextCursorOk() (*string, bool) {
	if o == nil {
		return nil, false
	}
	return o.NextCursor.Get(), o.NextCursor.IsSet()
}

// SetNextCursor sets field value
func (o *EpisodeList) SetNextCursor(v string) {
	o.NextCursor.Set(&v)
}

func (o EpisodeList) MarshalJSON() ([]byte, error) {
	toSerialize,err := o.ToMap()
	if err != nil {
		return []byte{}, err
	}
	return json.Marshal(toSerialize)
}

func (o EpisodeList) ToMap() (map[string]interface{}, error) {
	toSerialize := map[string]interface{}{}
	toSerialize["episodes"] = o.Episodes
	toSerialize["next_cursor"] = o.NextCursor.Get()

	for key, value := range o.AdditionalProperties {
		toSerialize[key] = value
	}

	return toSerialize, nil
}

func (o *EpisodeList) UnmarshalJSON(data []byte) (err error) {
	// This validates that all required properties are included in the JSON object
	// by unmarshalling the object into a generic map with string keys and checking
	// that every required field exists as a key in the generic map.
	requiredProperties := []string{
		"episodes",
		"next_cursor",
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

	varEpisodeList := _EpisodeList{}

	err = json.Unmarshal(data, &varEpisodeList)

	if err != nil {
		return err
	}

	*o = EpisodeList(varEpisodeList)

	additionalProperties := make(map[string]interface{})

	if err = json.Unmarshal(data, &additionalProperties); err == nil {
		delete(additionalProperties, "episodes")
		delete(additionalProperties, "next_cursor")
		o.AdditionalProperties = additionalProperties
	}

	return err
}

type NullableEpisodeList struct {
	value *EpisodeList
	isSet bool
}

func (v NullableEpisodeList) Get() *EpisodeList {
	return v.value
}

func (v *NullableEpisodeList) Set(val *EpisodeList) {
	v.value = val
	v.isSet = true
}

func (v NullableEpisodeList) IsSet() bool {
	return v.isSet
}

func (v *NullableEpisodeList) Unset() {
	v.value = nil
	v.isSet = false
}

func NewNullableEpisodeList(val *EpisodeList) *NullableEpisodeList {
	return &NullableEpisodeList{value: val, isSet: true}
}

func (v NullableEpisodeList) MarshalJSON() ([]byte, error) {
	return json.Marshal(v.value)
}

func (v *NullableEpisodeList) UnmarshalJSON(src []byte) error {
	v.isSet = true
	return json.Unmarshal(src, &v.value)
}
