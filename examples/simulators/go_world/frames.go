package main

import (
	"encoding/binary"
	"errors"
	"io"
	"math"
)

// Map is a map of MessagePack. Other values are nil, bool, int, int64, float64, string,
// []byte and []any.
type Map map[string]any

var errCut = errors.New("a message ends early")

func number(value any) float64 {
	switch n := value.(type) {
	case int64:
		return float64(n)
	case float64:
		return n
	}
	return 0
}

func receive(input io.Reader) (Map, error) {
	var length [4]byte
	if _, err := io.ReadFull(input, length[:]); err != nil {
		return nil, err
	}
	body := make([]byte, binary.BigEndian.Uint32(length[:]))
	if _, err := io.ReadFull(input, body); err != nil {
		return nil, err
	}
	reader := reader{rest: body}
	value := reader.value()
	request, isMap := value.(Map)
	if reader.isCut || !isMap {
		return nil, errCut
	}
	return request, nil
}

func send(output io.Writer, reply Map) {
	message := appendValue(make([]byte, 4), reply)
	binary.BigEndian.PutUint32(message, uint32(len(message)-4))
	output.Write(message)
}

func appendValue(to []byte, value any) []byte {
	switch v := value.(type) {
	case nil:
		return append(to, 0xc0)
	case bool:
		if v {
			return append(to, 0xc3)
		}
		return append(to, 0xc2)
	case int:
		return binary.BigEndian.AppendUint64(append(to, 0xd3), uint64(v))
	case int64:
		return binary.BigEndian.AppendUint64(append(to, 0xd3), uint64(v))
	case float64:
		return binary.BigEndian.AppendUint64(append(to, 0xcb), math.Float64bits(v))
	case string:
		return append(appendLength(to, 0xdb, len(v)), v...)
	case []byte:
		return append(appendLength(to, 0xc6, len(v)), v...)
	case []any:
		to = appendLength(to, 0xdd, len(v))
		for _, member := range v {
			to = appendValue(to, member)
		}
		return to
	case Map:
		to = appendLength(to, 0xdf, len(v))
		for name, member := range v {
			to = appendValue(appendValue(to, name), member)
		}
		return to
	}
	panic("no such value in MessagePack")
}

// Every length is written with four bytes, which MessagePack allows.
func appendLength(to []byte, kind byte, length int) []byte {
	return binary.BigEndian.AppendUint32(append(to, kind), uint32(length))
}

type reader struct {
	rest  []byte
	isCut bool
}

func (r *reader) take(size uint64) []byte {
	if size > uint64(len(r.rest)) {
		r.isCut, r.rest = true, nil
		return make([]byte, 8)
	}
	taken := r.rest[:size]
	r.rest = r.rest[size:]
	return taken
}

func (r *reader) unsigned(size uint64) (value uint64) {
	for _, digit := range r.take(size)[:size] {
		value = value<<8 | uint64(digit)
	}
	return value
}

func (r *reader) value() any {
	kind := r.take(1)[0]
	switch {
	case r.isCut || kind == 0xc0:
		return nil
	case kind < 0x80:
		return int64(kind)
	case kind < 0x90:
		return r.members(uint64(kind & 15))
	case kind < 0xa0:
		return r.list(uint64(kind & 15))
	case kind < 0xc0:
		return string(r.take(uint64(kind & 31)))
	case kind >= 0xe0:
		return int64(int8(kind))
	}
	switch kind {
	case 0xc2, 0xc3:
		return kind == 0xc3
	case 0xc4, 0xc5, 0xc6:
		return r.take(r.unsigned(1 << (kind - 0xc4)))
	case 0xca:
		return float64(math.Float32frombits(uint32(r.unsigned(4))))
	case 0xcb:
		return math.Float64frombits(r.unsigned(8))
	case 0xcc, 0xcd, 0xce, 0xcf:
		return int64(r.unsigned(1 << (kind - 0xcc)))
	case 0xd0, 0xd1, 0xd2, 0xd3:
		size := uint64(1) << (kind - 0xd0)
		unused := 64 - 8*size
		return int64(r.unsigned(size)<<unused) >> unused
	case 0xd9, 0xda, 0xdb:
		return string(r.take(r.unsigned(1 << (kind - 0xd9))))
	case 0xdc, 0xdd:
		return r.list(r.unsigned(2 << (kind - 0xdc)))
	case 0xde, 0xdf:
		return r.members(r.unsigned(2 << (kind - 0xde)))
	}
	r.isCut = true
	return nil
}

func (r *reader) list(size uint64) []any {
	values := []any{}
	for ; size > 0 && !r.isCut; size-- {
		values = append(values, r.value())
	}
	return values
}

func (r *reader) members(size uint64) Map {
	members := Map{}
	for ; size > 0 && !r.isCut; size-- {
		name, _ := r.value().(string)
		members[name] = r.value()
	}
	return members
}
