// JSON of RFC 8259, stricter than encoding/json: a lone surrogate, a number beyond a double
// and bytes that are no UTF-8 are refused instead of repaired (ERR-002), and nesting is
// bounded before anything is built (ERR-006). Floats keep the sign of zero.
package wire

import (
	"encoding/base64"
	"errors"
	"math"
	"regexp"
	"strconv"
	"unicode/utf16"
	"unicode/utf8"
)

var (
	errMalformed = errors.New("not one well-formed document")
	errTooDeep   = errors.New("nested too deeply")
	jsonNumber   = regexp.MustCompile(`^-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?`)
)

type jsonReader struct {
	text []byte
	at   int
}

func ParseJSON(text []byte) (any, error) {
	if !utf8.Valid(text) {
		return nil, errMalformed
	}
	reader := &jsonReader{text: text}
	value, err := reader.value(0)
	if err != nil {
		return nil, err
	}
	if reader.skip(); reader.at != len(text) {
		return nil, errMalformed
	}
	return value, nil
}

// skip moves over white space and returns the next byte, 0 at the end.
func (r *jsonReader) skip() byte {
	for r.at < len(r.text) {
		switch c := r.text[r.at]; c {
		case ' ', '\t', '\n', '\r':
			r.at++
		default:
			return c
		}
	}
	return 0
}

func (r *jsonReader) value(depth int) (any, error) {
	if depth > maxDepth {
		return nil, errTooDeep
	}
	switch r.skip() {
	case '{':
		return r.object(depth)
	case '[':
		return r.array(depth)
	case '"':
		return r.string()
	case 't':
		return true, r.word("true")
	case 'f':
		return false, r.word("false")
	case 'n':
		return nil, r.word("null")
	}
	return r.number()
}

func (r *jsonReader) word(word string) error {
	if end := r.at + len(word); end <= len(r.text) && string(r.text[r.at:end]) == word {
		r.at = end
		return nil
	}
	return errMalformed
}

// number refuses NaN, Infinity (ERR-013) and what no double can hold.
func (r *jsonReader) number() (any, error) {
	found := jsonNumber.Find(r.text[r.at:])
	if found == nil {
		return nil, errMalformed
	}
	r.at += len(found)
	number, err := strconv.ParseFloat(string(found), 64)
	if math.IsInf(number, 0) {
		return nil, err
	}
	return number, nil
}

func (r *jsonReader) array(depth int) (any, error) {
	items := []any{}
	r.at++
	if r.skip() == ']' {
		r.at++
		return items, nil
	}
	for {
		item, err := r.value(depth + 1)
		if err != nil {
			return nil, err
		}
		items = append(items, item)
		if more, err := r.next(']'); !more {
			return items, err
		}
	}
}

// object refuses two members with one name (ENC-013).
func (r *jsonReader) object(depth int) (any, error) {
	members := map[string]any{}
	r.at++
	if r.skip() == '}' {
		r.at++
		return members, nil
	}
	for {
		if r.skip() != '"' {
			return nil, errMalformed
		}
		name, err := r.string()
		if err != nil {
			return nil, err
		}
		if _, stands := members[name]; stands || r.skip() != ':' {
			return nil, errMalformed
		}
		r.at++
		if members[name], err = r.value(depth + 1); err != nil {
			return nil, err
		}
		if more, err := r.next('}'); !more {
			return members, err
		}
	}
}

// next moves over a comma or the closing byte, and reports whether something follows.
func (r *jsonReader) next(closing byte) (bool, error) {
	c := r.skip()
	if c != ',' && c != closing {
		return false, errMalformed
	}
	r.at++
	return c == ',', nil
}

func (r *jsonReader) string() (string, error) {
	var out []byte
	for r.at++; r.at < len(r.text); r.at++ {
		switch c := r.text[r.at]; {
		case c == '"':
			r.at++
			return string(out), nil
		case c < 0x20:
			return "", errMalformed
		case c != '\\':
			out = append(out, c)
		default:
			char, err := r.escape()
			if err != nil {
				return "", err
			}
			out = utf8.AppendRune(out, char)
		}
	}
	return "", errMalformed
}

var shortEscapes = map[byte]rune{
	'"': '"', '\\': '\\', '/': '/', 'b': '\b', 'f': '\f', 'n': '\n', 'r': '\r', 't': '\t',
}

// escape reads from the backslash and leaves the position on the last byte of the escape.
func (r *jsonReader) escape() (rune, error) {
	r.at++
	if r.at >= len(r.text) {
		return 0, errMalformed
	}
	if char, known := shortEscapes[r.text[r.at]]; known {
		return char, nil
	}
	first, err := r.hex()
	if err != nil || !utf16.IsSurrogate(first) {
		return first, err
	}
	if r.at+2 >= len(r.text) || r.text[r.at+1] != '\\' {
		return 0, errMalformed
	}
	r.at += 2
	second, err := r.hex()
	if err != nil {
		return 0, err
	}
	pair := utf16.DecodeRune(first, second)
	if pair == utf8.RuneError {
		return 0, errMalformed
	}
	return pair, nil
}

func (r *jsonReader) hex() (rune, error) {
	if r.text[r.at] != 'u' || r.at+4 >= len(r.text) {
		return 0, errMalformed
	}
	code := rune(0)
	for range 4 {
		r.at++
		digit, err := strconv.ParseUint(string(r.text[r.at]), 16, 8)
		if err != nil {
			return 0, errMalformed
		}
		code = code<<4 | rune(digit)
	}
	return code, nil
}

func AppendJSON(out []byte, value any) []byte {
	switch v := value.(type) {
	case nil:
		return append(out, "null"...)
	case bool:
		return strconv.AppendBool(out, v)
	case int:
		return strconv.AppendInt(out, int64(v), 10)
	case int64:
		return strconv.AppendInt(out, v, 10)
	case float64:
		return appendFloat(out, v)
	case string:
		return appendString(out, v)
	case []byte:
		out = base64.StdEncoding.AppendEncode(append(out, '"'), v)
		return append(out, '"')
	case []string:
		return appendItems(out, v)
	case []float64:
		return appendItems(out, v)
	case []int:
		return appendItems(out, v)
	case []Object:
		return appendItems(out, v)
	case []any:
		return appendItems(out, v)
	case Object:
		out = append(out, '{')
		for i, m := range v {
			if i > 0 {
				out = append(out, ',')
			}
			out = append(appendString(out, m.Name), ':')
			out = AppendJSON(out, m.Value)
		}
		return append(out, '}')
	}
	panic("answer with a value of an unexpected type")
}

func appendItems[T any](out []byte, items []T) []byte {
	out = append(out, '[')
	for i, item := range items {
		if i > 0 {
			out = append(out, ',')
		}
		out = AppendJSON(out, item)
	}
	return append(out, ']')
}

// appendFloat writes the shortest digits that give the same bits back (ENC-003). A whole
// number gets ".0", because some readers take -0 for the integer zero.
func appendFloat(out []byte, number float64) []byte {
	if number == math.Trunc(number) && math.Abs(number) < 1e15 {
		return strconv.AppendFloat(out, number, 'f', 1, 64)
	}
	return strconv.AppendFloat(out, number, 'g', -1, 64)
}

func appendString(out []byte, text string) []byte {
	out = append(out, '"')
	for _, char := range text {
		switch {
		case char == '"' || char == '\\':
			out = append(out, '\\', byte(char))
		case char < 0x20:
			const digits = "0123456789abcdef"
			out = append(out, '\\', 'u', '0', '0', digits[char>>4], digits[char&15])
		default:
			out = utf8.AppendRune(out, char)
		}
	}
	return append(out, '"')
}
