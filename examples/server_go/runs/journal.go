// The journal: what must survive a kill, one JSON line per change, synced before the answer
// that promises it (CRASH-001, EVT-009). Changes that wait at the same time share a sync.
// Without a path nothing is stored. It knows no rule of the protocol.
package runs

import (
	"bytes"
	"encoding/json"
	"fmt"
	"log"
	"os"
	"path/filepath"
	"time"
)

// submission makes a run; Body is the request as it was parsed.
type submission struct {
	ID      string          `json:"id"`
	Number  int             `json:"number"`
	Account string          `json:"account"`
	Key     string          `json:"key"`
	Created time.Time       `json:"created"`
	Body    json.RawMessage `json:"body"`
}

// change holds all of a run that is not in its episodes, and the episodes that changed.
type change struct {
	Run      string    `json:"run"`
	View     view      `json:"view"`
	Visible  bool      `json:"visible"`
	Updated  time.Time `json:"updated"`
	ReadyAt  time.Time `json:"ready_at"`
	Episodes []episode `json:"episodes,omitempty"`
}

type journalRecord struct {
	Submission *submission `json:"submission,omitempty"`
	Change     *change     `json:"change,omitempty"`
}

type journalEntry struct {
	lines  []byte
	synced chan struct{}
}

type journal struct {
	entries chan journalEntry
}

// OpenJournal gives the records that are there. A line that was cut off by a kill promised
// nothing yet and is removed.
func OpenJournal(path string) (*journal, []journalRecord, error) {
	if path == "" {
		return &journal{}, nil, nil
	}
	text, err := os.ReadFile(path)
	if err != nil && !os.IsNotExist(err) {
		return nil, nil, err
	}
	whole := text[:bytes.LastIndexByte(text, '\n')+1]
	records := []journalRecord{}
	for line := range bytes.Lines(whole) {
		var read journalRecord
		if err := json.Unmarshal(line, &read); err != nil {
			return nil, nil, fmt.Errorf("%s: %w", path, err)
		}
		records = append(records, read)
	}
	file, err := os.OpenFile(path, os.O_CREATE|os.O_RDWR, 0o600)
	if err != nil {
		return nil, nil, err
	}
	if err := file.Truncate(int64(len(whole))); err != nil {
		return nil, nil, err
	}
	if _, err := file.Seek(int64(len(whole)), 0); err != nil {
		return nil, nil, err
	}
	if folder, err := os.Open(filepath.Dir(path)); err == nil {
		_ = folder.Sync() // so that the new file's name survives, too
		_ = folder.Close()
	}
	made := &journal{make(chan journalEntry, 64)}
	go made.write(file)
	return made, records, nil
}

// append returns when the records are on the disk.
func (j *journal) append(records ...journalRecord) {
	if j.entries == nil {
		return
	}
	var lines []byte
	for _, r := range records {
		line, err := json.Marshal(r)
		if err != nil {
			panic(err)
		}
		lines = append(append(lines, line...), '\n')
	}
	entry := journalEntry{lines, make(chan struct{})}
	j.entries <- entry
	<-entry.synced
}

// write ends the process when the disk fails: what is in memory cannot be promised then.
func (j *journal) write(file *os.File) {
	for entry := range j.entries {
		batch := []journalEntry{entry}
		for waiting := len(j.entries); waiting > 0; waiting-- {
			batch = append(batch, <-j.entries)
		}
		var lines []byte
		for _, e := range batch {
			lines = append(lines, e.lines...)
		}
		if _, err := file.Write(lines); err != nil {
			log.Fatal(err)
		}
		if err := file.Sync(); err != nil {
			log.Fatal(err)
		}
		for _, e := range batch {
			close(e.synced)
		}
	}
}
