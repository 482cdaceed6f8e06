package main

import (
	"bytes"
	"encoding/json"
	"io"
	"math"
	"unicode/utf8"
)

// object is a JSON object of one file. Not a struct: encoding/json would match names
// whatever their case, and take the last of two members of one name (REC-004).
type object struct {
	file    string
	members map[string]any
}

func readObject(file string, data []byte) *object {
	if !utf8.Valid(data) {
		refuse(file, "REC-004", "it is not UTF-8")
	}
	decoder := json.NewDecoder(bytes.NewReader(data))
	value := readValue(file, decoder, 0)
	if _, err := decoder.Token(); err != io.EOF {
		refuse(file, "REC-004", "something stands behind the JSON")
	}
	return asObject(file, value)
}

func readValue(file string, decoder *json.Decoder, depth int) any {
	token, err := decoder.Token()
	if err != nil || depth > 500 {
		refuse(file, "REC-004", "it is no JSON")
	}
	switch token {
	case json.Delim('{'):
		members := map[string]any{}
		for decoder.More() {
			name, is := readValue(file, decoder, depth+1).(string)
			if _, twice := members[name]; !is || twice {
				refuse(file, "REC-004", "the member %q stands twice", name)
			}
			members[name] = readValue(file, decoder, depth+1)
		}
		readEnd(file, decoder)
		return members
	case json.Delim('['):
		items := []any{}
		for decoder.More() {
			items = append(items, readValue(file, decoder, depth+1))
		}
		readEnd(file, decoder)
		return items
	}
	return token
}

func readEnd(file string, decoder *json.Decoder) {
	if _, err := decoder.Token(); err != nil {
		refuse(file, "REC-004", "it is no JSON")
	}
}

func asObject(file string, value any) *object {
	members, is := value.(map[string]any)
	if !is {
		refuse(file, "REC-004", "it has no object where one is expected")
	}
	return &object{file, members}
}

func (o *object) has(name string) bool { return o.members[name] != nil }

func (o *object) object(name string) *object { return asObject(o.file, o.members[name]) }

func (o *object) text(name string) string {
	text, is := o.members[name].(string)
	if !is {
		refuse(o.file, "REC-004", "%s is no text", name)
	}
	return text
}

func (o *object) flag(name string) bool {
	flag, is := o.members[name].(bool)
	if !is {
		refuse(o.file, "REC-004", "%s is neither true nor false", name)
	}
	return flag
}

func (o *object) number(name string) float64 {
	number, is := o.members[name].(float64)
	if !is {
		refuse(o.file, "REC-004", "%s is no number", name)
	}
	return number
}

func (o *object) count(name string) int64 {
	number := o.number(name)
	if number != math.Trunc(number) || number < 0 || number > 1<<53 {
		refuse(o.file, "REC-004", "%s is no count", name)
	}
	return int64(number)
}

func (o *object) length(name string) int64 {
	items, is := o.members[name].([]any)
	if !is {
		refuse(o.file, "REC-004", "%s is no list", name)
	}
	return int64(len(items))
}

func (o *object) objects(name string) []*object {
	items, is := o.members[name].([]any)
	if !is {
		refuse(o.file, "REC-004", "%s is no list", name)
	}
	found := make([]*object, len(items))
	for place, item := range items {
		found[place] = asObject(o.file, item)
	}
	return found
}
