// MessagePack of the data plane: the same values as JSON, `data` as bin, no extension types
// (ENC-002, ENC-008). Every length is compared with the bytes that are left before anything
// is built from it.
package wire

import (
	"encoding/binary"
	"math"
	"unicode/utf8"
)

type msgpackReader struct {
	left []byte
}

func ParseMsgpack(text []byte) (any, error) {
	reader := &msgpackReader{text}
	value, err := reader.value(0)
	if err == nil && len(reader.left) > 0 {
		err = errMalformed
	}
	return value, err
}

func (r *msgpackReader) take(count uint64) ([]byte, error) {
	if count > uint64(len(r.left)) {
		return nil, errMalformed
	}
	taken := r.left[:count]
	r.left = r.left[count:]
	return taken, nil
}

// unsigned reads a big-endian number of 1, 2, 4 or 8 bytes.
func (r *msgpackReader) unsigned(size uint64) (uint64, error) {
	taken, err := r.take(size)
	number := uint64(0)
	for _, b := range taken {
		number = number<<8 | uint64(b)
	}
	return number, err
}

func (r *msgpackReader) value(depth int) (any, error) {
	if depth > maxDepth {
		return nil, errTooDeep
	}
	head, err := r.unsigned(1)
	if err != nil {
		return nil, err
	}
	switch {
	case head < 0x80:
		return float64(head), nil
	case head < 0x90:
		return r.members(head&0x0f, depth)
	case head < 0xa0:
		return r.items(head&0x0f, depth)
	case head < 0xc0:
		return r.text(head & 0x1f)
	case head >= 0xe0:
		return float64(int8(head)), nil
	}
	return r.wide(head, depth)
}

// wide reads what has its size or length behind its first byte.
func (r *msgpackReader) wide(head uint64, depth int) (any, error) {
	switch head {
	case 0xc0:
		return nil, nil
	case 0xc2, 0xc3:
		return head == 0xc3, nil
	case 0xca:
		bits, err := r.unsigned(4)
		return float64(math.Float32frombits(uint32(bits))), err
	case 0xcb:
		bits, err := r.unsigned(8)
		return math.Float64frombits(bits), err
	case 0xcc, 0xcd, 0xce, 0xcf:
		number, err := r.unsigned(1 << (head - 0xcc))
		return float64(number), err
	case 0xd0, 0xd1, 0xd2, 0xd3:
		size := uint64(1) << (head - 0xd0)
		number, err := r.unsigned(size)
		shift := 64 - 8*size
		return float64(int64(number<<shift) >> shift), err
	}
	widths := map[uint64]uint64{
		0xc4: 1, 0xc5: 2, 0xc6: 4, 0xd9: 1, 0xda: 2, 0xdb: 4, 0xdc: 2, 0xdd: 4, 0xde: 2, 0xdf: 4,
	}
	width, known := widths[head]
	if !known {
		return nil, errMalformed // extension types and 0xc1
	}
	count, err := r.unsigned(width)
	if err != nil {
		return nil, err
	}
	switch {
	case head <= 0xc6:
		return r.take(count)
	case head <= 0xdb:
		return r.text(count)
	case head <= 0xdd:
		return r.items(count, depth)
	}
	return r.members(count, depth)
}

func (r *msgpackReader) text(count uint64) (any, error) {
	taken, err := r.take(count)
	if err != nil || !utf8.Valid(taken) {
		return nil, errMalformed
	}
	return string(taken), nil
}

func (r *msgpackReader) items(count uint64, depth int) (any, error) {
	if count > uint64(len(r.left)) {
		return nil, errMalformed
	}
	items := make([]any, 0, count)
	for range count {
		item, err := r.value(depth + 1)
		if err != nil {
			return nil, err
		}
		items = append(items, item)
	}
	return items, nil
}

func (r *msgpackReader) members(count uint64, depth int) (any, error) {
	if count > uint64(len(r.left))/2 {
		return nil, errMalformed
	}
	members := make(map[string]any, count)
	for range count {
		key, err := r.value(depth + 1)
		if err != nil {
			return nil, err
		}
		name, isText := key.(string)
		if _, stands := members[name]; stands || !isText { // ENC-014
			return nil, errMalformed
		}
		if members[name], err = r.value(depth + 1); err != nil {
			return nil, err
		}
	}
	return members, nil
}

func AppendMsgpack(out []byte, value any) []byte {
	switch v := value.(type) {
	case nil:
		return append(out, 0xc0)
	case bool:
		if v {
			return append(out, 0xc3)
		}
		return append(out, 0xc2)
	case int:
		return appendInteger(out, int64(v))
	case int64:
		return appendInteger(out, v)
	case float64:
		return binary.BigEndian.AppendUint64(append(out, 0xcb), math.Float64bits(v))
	case string:
		return append(appendLength(out, len(v), 0xa0, 32, 0xd9, 0xda, 0xdb), v...)
	case []byte:
		return append(appendLength(out, len(v), 0, 0, 0xc4, 0xc5, 0xc6), v...)
	case []string:
		return packItems(out, v)
	case []float64:
		return packItems(out, v)
	case []int:
		return packItems(out, v)
	case []Object:
		return packItems(out, v)
	case []any:
		return packItems(out, v)
	case Object:
		out = appendLength(out, len(v), 0x80, 16, 0, 0xde, 0xdf)
		for _, m := range v {
			out = AppendMsgpack(AppendMsgpack(out, m.Name), m.Value)
		}
		return out
	}
	panic("answer with a value of an unexpected type")
}

func packItems[T any](out []byte, items []T) []byte {
	out = appendLength(out, len(items), 0x90, 16, 0, 0xdc, 0xdd)
	for _, item := range items {
		out = AppendMsgpack(out, item)
	}
	return out
}

// appendLength writes the shortest head; a head that a type does not have is 0.
func appendLength(out []byte, n int, short byte, below int, head8, head16, head32 byte) []byte {
	switch {
	case n < below:
		return append(out, short|byte(n))
	case head8 != 0 && n < 1<<8:
		return append(out, head8, byte(n))
	case n < 1<<16:
		return binary.BigEndian.AppendUint16(append(out, head16), uint16(n))
	}
	return binary.BigEndian.AppendUint32(append(out, head32), uint32(n))
}

func appendInteger(out []byte, number int64) []byte {
	if number >= -32 && number < 128 {
		return append(out, byte(number))
	}
	return binary.BigEndian.AppendUint64(append(out, 0xd3), uint64(number))
}
