package main

import (
	"encoding/binary"
	"io"

	"github.com/klauspost/compress/zstd"
)

const (
	mcapMagic      = "\x89MCAP0\r\n"
	recordBytesMax = 1 << 26
	channelsMax    = 256
	// Added to the size of each record in a chunk: a small one takes time, too.
	chunkedRecordBytes = 64

	opFooter, opSchema, opChannel, opMessage, opChunk, opLast = 0x02, 0x03, 0x04, 0x05, 0x06, 0x0F
)

// mcap reads the messages of a recording from front to back, within bounds (REC-030).
type mcap struct {
	name     string
	file     io.Reader
	left     int64
	expanded int64
	topics   map[uint16]string
	decoder  *zstd.Decoder
	each     func(topic string, data []byte)
}

func readMessages(name string, file *io.SectionReader, each func(string, []byte)) {
	decoder, _ := zstd.NewReader(nil, zstd.WithDecoderConcurrency(1),
		zstd.WithDecoderMaxMemory(recordBytesMax), zstd.WithDecodeAllCapLimit(true))
	defer decoder.Close()
	size := file.Size()
	reader := &mcap{name, file, size, 1000*size + 1<<26, map[uint16]string{}, decoder, each}
	reader.magic()
	for {
		head := reader.take(9)
		content := reader.take(int64(binary.LittleEndian.Uint64(head[1:])))
		if head[0] == opFooter {
			break
		}
		if head[0] == opChunk {
			reader.records(reader.expand(content))
		} else {
			reader.record(head[0], content)
		}
	}
	reader.magic()
	if reader.left != 0 {
		reader.malformed("bytes stand behind its end")
	}
}

func (m *mcap) malformed(detail string) { refuse(m.name, "REC-012", "%s", detail) }

func (m *mcap) magic() {
	if string(m.take(int64(len(mcapMagic)))) != mcapMagic {
		m.malformed("it does not begin or end as an MCAP file")
	}
}

func (m *mcap) bound(count, most int64) {
	if count < 0 || count > most {
		refuse(m.name, "REC-030", "a part of it has more than %d bytes", most)
	}
}

func (m *mcap) take(count int64) []byte {
	if count < 0 || count > m.left {
		m.malformed("it is cut")
	}
	m.bound(count, recordBytesMax)
	m.left -= count
	data := make([]byte, count)
	if _, err := io.ReadFull(m.file, data); err != nil {
		m.malformed("it is cut")
	}
	return data
}

// cut gives the first count bytes of data, and the rest.
func (m *mcap) cut(data []byte, count uint64) ([]byte, []byte) {
	if count > uint64(len(data)) {
		m.malformed("a record in it is cut")
	}
	return data[:count], data[count:]
}

// charge counts what chunks hold, which may be far more than the file.
func (m *mcap) charge(count int64) {
	m.expanded -= count
	if m.expanded < 0 {
		refuse(m.name, "REC-030", "its chunks have too many bytes or records for its size")
	}
}

func (m *mcap) expand(chunk []byte) []byte {
	head, rest := m.cut(chunk, 32)
	size := binary.LittleEndian.Uint64(head[16:])
	word, rest := m.cut(rest, uint64(binary.LittleEndian.Uint32(head[28:])))
	length, data := m.cut(rest, 8)
	if binary.LittleEndian.Uint64(length) != uint64(len(data)) {
		m.malformed("a chunk is cut")
	}
	m.bound(int64(size), recordBytesMax)
	m.charge(int64(size))
	switch string(word) {
	case "":
	case "zstd":
		data = m.decompress(data, size)
	default:
		m.malformed("a chunk is compressed by something else than zstd")
	}
	if uint64(len(data)) != size {
		m.malformed("a chunk has another size than it says")
	}
	return data
}

func (m *mcap) decompress(data []byte, size uint64) []byte {
	var header zstd.Header
	if err := header.Decode(data); err != nil || !header.HasFCS || header.FrameContentSize != size {
		m.malformed("a chunk has another size than it says")
	}
	out, err := m.decoder.DecodeAll(data, make([]byte, 0, size))
	if err != nil {
		m.malformed("a chunk cannot be decompressed")
	}
	return out
}

func (m *mcap) records(data []byte) {
	for len(data) > 0 {
		var head, content []byte
		head, data = m.cut(data, 9)
		content, data = m.cut(data, binary.LittleEndian.Uint64(head[1:]))
		m.charge(chunkedRecordBytes)
		if head[0] != opSchema && head[0] != opChannel && head[0] != opMessage {
			m.malformed("a chunk holds what cannot stand in one")
		}
		m.record(head[0], content)
	}
}

func (m *mcap) record(code byte, content []byte) {
	switch {
	case code == opMessage:
		head, data := m.cut(content, 22)
		topic, known := m.topics[binary.LittleEndian.Uint16(head)]
		if !known {
			m.malformed("a message has no channel")
		}
		m.each(topic, data)
	case code == opChannel:
		head, rest := m.cut(content, 8)
		topic, _ := m.cut(rest, uint64(binary.LittleEndian.Uint32(head[4:])))
		id := binary.LittleEndian.Uint16(head)
		if before, known := m.topics[id]; known && before != string(topic) {
			m.malformed("a channel stands twice with different topics")
		}
		m.topics[id] = string(topic)
		if len(m.topics) > channelsMax {
			refuse(m.name, "REC-030", "it has too many channels")
		}
	case code == 0 || code > opLast:
		m.malformed("it has a record of an unknown kind")
	}
}
