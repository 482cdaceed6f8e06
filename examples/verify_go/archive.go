package main

import (
	"bytes"
	"encoding/binary"
	"fmt"
	"hash/crc32"
	"io"
	"os"
	"regexp"
	"strings"
)

// broken names the first thing that is wrong (REC-029). Functions below panic with it,
// and verify recovers: nothing may go on behind what is wrong.
type broken struct{ file, rule, detail string }

func (b *broken) Error() string { return b.file + ": " + b.detail + " [" + b.rule + "]" }

func refuse(file, rule, format string, values ...any) {
	panic(&broken{file, rule, fmt.Sprintf(format, values...)})
}

const (
	statementName = "statement.dsse.json"
	manifestName  = "manifest.json"
	episodesName  = "episodes.jsonl"
	archiveName   = "archive"

	recordingsMax = 65000
	verdictsMax   = 100
	nameBytesMax  = 96
	localSize     = 30
)

var (
	recordingPattern = regexp.MustCompile(`^episodes/[0-9]{5}\.mcap$`)
	verdictPattern   = regexp.MustCompile(`^verdicts/[a-z0-9-]{1,64}\.dsse\.json$`)
	// Version, flags, method, time, date (REC-002).
	constants = []byte{10, 0, 0, 0, 0, 0, 0, 0, 0x21, 0}
)

// entry is a file of the archive; at is the place of its local header.
type entry struct {
	name    string
	crc     uint32
	size    int64
	at      int64
	content int64
}

// archive reads the files of a record, within bounds.
type archive struct {
	file    io.ReaderAt
	entries []entry
	byName  map[string]entry
}

func isRecording(name string) bool { return recordingPattern.MatchString(name) }
func isVerdict(name string) bool   { return verdictPattern.MatchString(name) }

// rank orders the kinds of files as they stand in an archive.
func rank(name string) int {
	for place, fixed := range []string{statementName, manifestName, episodesName} {
		if name == fixed {
			return place
		}
	}
	if isRecording(name) {
		return 3
	}
	return 4
}

// sizeMax is the most bytes that are read of a file (REC-030), 0 for an unknown name.
func sizeMax(name string) int64 {
	switch {
	case name == statementName || name == manifestName:
		return 1 << 24
	case name == episodesName:
		return 1 << 28
	case isRecording(name):
		return 1<<32 - 1
	case isVerdict(name):
		return 1 << 20
	}
	return 0
}

func openArchive(file *os.File, size int64) *archive {
	found := &archive{file: file, byName: map[string]entry{}}
	at := int64(0)
	for {
		magic := make([]byte, 4)
		n, _ := file.ReadAt(magic, at)
		if n < 4 || !bytes.Equal(magic, []byte("PK\x03\x04")) {
			break
		}
		next := readLocal(file, at, size)
		found.add(next)
		at = next.content + next.size
	}
	if len(found.entries) == 0 {
		refuse(archiveName, "REC-002", "this is no zip archive")
	}
	expected := directory(found.entries, at)
	rest := make([]byte, len(expected)+1)
	n, _ := file.ReadAt(rest, at)
	if !bytes.Equal(rest[:n], expected) {
		refuse(archiveName, "REC-002", "its end does not fit its files")
	}
	found.checkNames()
	return found
}

func readLocal(file *os.File, at, size int64) entry {
	header := make([]byte, localSize)
	if n, _ := file.ReadAt(header, at); n < localSize {
		refuse(archiveName, "REC-002", "it ends in the header of a file")
	}
	length := int(binary.LittleEndian.Uint16(header[26:]))
	name := make([]byte, min(length, nameBytesMax))
	n, _ := file.ReadAt(name, at+localSize)
	sizes := header[18:22]
	if !bytes.Equal(header[4:14], constants) || !bytes.Equal(sizes, header[22:26]) ||
		!bytes.Equal(header[28:30], []byte{0, 0}) {
		refuse(string(name[:n]), "REC-002", "its header is not as a record has it")
	}
	if n < length {
		refuse(archiveName, "REC-002", "the name of a file is cut or too long")
	}
	found := entry{
		name: string(name),
		crc:  binary.LittleEndian.Uint32(header[14:]),
		size: int64(binary.LittleEndian.Uint32(sizes)),
		at:   at, content: at + localSize + int64(length),
	}
	most := sizeMax(found.name)
	if most == 0 {
		refuse(found.name, "REC-001", "a record has no file of this name")
	}
	if found.size > most {
		refuse(found.name, "REC-030", "it has more than %d bytes", most)
	}
	return found.within(size)
}

func (e entry) within(size int64) entry {
	if e.content+e.size > size {
		// What is wrong with the order is said first, by add.
		e.size = -1
	}
	return e
}

func (a *archive) add(next entry) {
	if count := len(a.entries); count > 0 {
		last := a.entries[count-1].name
		if count >= 3+recordingsMax+verdictsMax {
			refuse(archiveName, "REC-030", "it has too many files")
		}
		if rank(last) > rank(next.name) || (rank(last) == rank(next.name) && last >= next.name) {
			refuse(next.name, "REC-002", "it stands twice or out of order")
		}
	}
	if next.size < 0 {
		refuse(next.name, "REC-002", "the archive ends inside of this file")
	}
	a.entries = append(a.entries, next)
	a.byName[next.name] = next
}

// checkNames is about the files that each record has (REC-001), and how many (REC-030).
func (a *archive) checkNames() {
	for _, name := range []string{statementName, manifestName, episodesName} {
		if _, has := a.byName[name]; !has {
			refuse(name, "REC-001", "this file is missing")
		}
	}
	recordings, verdicts := 0, 0
	for _, one := range a.entries {
		if isRecording(one.name) {
			recordings++
		} else if isVerdict(one.name) {
			verdicts++
		}
	}
	if recordings > recordingsMax {
		refuse("episodes", "REC-030", "it has too many recordings")
	}
	if verdicts > verdictsMax {
		refuse("verdicts", "REC-030", "it has too many verdicts")
	}
}

// directory is what stands behind the files (REC-002).
func directory(entries []entry, at int64) []byte {
	var out bytes.Buffer
	put := func(values ...any) {
		for _, value := range values {
			_ = binary.Write(&out, binary.LittleEndian, value)
		}
	}
	for _, one := range entries {
		out.WriteString("PK\x01\x02")
		put(uint16(10), constants, one.crc, uint32(one.size), uint32(one.size))
		put(uint16(len(one.name)), [4]uint16{}, uint32(0), uint32(one.at))
		out.WriteString(one.name)
	}
	length, count := uint32(out.Len()), uint16(len(entries))
	out.WriteString("PK\x05\x06")
	put([2]uint16{}, count, count, length, uint32(at), uint16(0))
	return out.Bytes()
}

func (a *archive) open(name string) *io.SectionReader {
	one := a.byName[name]
	return io.NewSectionReader(a.file, one.content, one.size)
}

func (a *archive) read(name string) []byte {
	data, err := io.ReadAll(a.open(name))
	if err != nil || int64(len(data)) != a.byName[name].size {
		refuse(name, "REC-002", "the file is cut")
	}
	return data
}

// digest is the SHA-256 of a file; its CRC-32 is checked beside it.
func (a *archive) digest(name string) string {
	sum, crc := newSHA256(), crc32.NewIEEE()
	if _, err := io.Copy(io.MultiWriter(sum, crc), a.open(name)); err != nil {
		refuse(name, "REC-002", "the file is cut")
	}
	if crc.Sum32() != a.byName[name].crc {
		refuse(name, "REC-002", "its CRC-32 is not that of its bytes")
	}
	return hexOf(sum)
}

// names are those of the files that a statement lists, in order.
func (a *archive) names() []string {
	var names []string
	for _, one := range a.entries {
		if one.name != statementName && !strings.HasPrefix(one.name, "verdicts/") {
			names = append(names, one.name)
		}
	}
	return names
}
