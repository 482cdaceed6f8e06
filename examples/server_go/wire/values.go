// Values that travel: what a parsed body is made of, and how answers are built.
//
// A parsed body consists of nil, bool, float64, string, []byte (MessagePack bin), []any and
// map[string]any, whatever its encoding was. An answer is an object, whose members keep
// their order, and is written as JSON (json.go) or MessagePack (msgpack.go).
package wire

import (
	"crypto/sha256"
	"math"
	"slices"
	"strconv"
)

type Member = struct {
	Name  string
	Value any
}

type Object []Member

// maxDepth bounds the nesting of a body in both encodings (ERR-006).
const maxDepth = 64

// Digest is equal for two bodies exactly when their parsed values are.
func Digest(value any) [sha256.Size]byte {
	return sha256.Sum256(appendCanonical(nil, value))
}

func appendCanonical(out []byte, value any) []byte {
	switch v := value.(type) {
	case nil:
		return append(out, 'n')
	case bool:
		return strconv.AppendBool(out, v)
	case float64:
		if v == 0 {
			v = 0 // −0 equals 0
		}
		return append(strconv.AppendUint(append(out, '#'), math.Float64bits(v), 16), ';')
	case string:
		return strconv.AppendQuote(out, v)
	case []byte:
		return strconv.AppendQuote(append(out, 'b'), string(v))
	case []any:
		out = append(out, '[')
		for _, item := range v {
			out = append(appendCanonical(out, item), ',')
		}
		return append(out, ']')
	case map[string]any:
		out = append(out, '{')
		for _, name := range SortedKeys(v) {
			out = append(strconv.AppendQuote(out, name), ':')
			out = append(appendCanonical(out, v[name]), ',')
		}
		return append(out, '}')
	}
	panic("value of an unexpected type")
}

func SortedKeys(values map[string]any) []string {
	names := make([]string, 0, len(values))
	for name := range values {
		names = append(names, name)
	}
	slices.Sort(names)
	return names
}

// Plain turns a parsed value into one that the writers know.
func Plain(value any) any {
	switch v := value.(type) {
	case map[string]any:
		made := Object{}
		for _, name := range SortedKeys(v) {
			made = append(made, Member{name, Plain(v[name])})
		}
		return made
	case []any:
		made := make([]any, len(v))
		for i, item := range v {
			made[i] = Plain(item)
		}
		return made
	}
	return value
}

// OrNull is the text, or null for an empty one.
func OrNull(text string) any {
	if text == "" {
		return nil
	}
	return text
}
