// The runs of all accounts: submit and its Idempotency-Key, look-up, pages, and what a
// restart finds in the journal.
package runs

import (
	"crypto/rand"
	"encoding/json"
	"fmt"
	"strconv"
	"strings"
	"sync"
	"time"

	"proctor-server-go/wire"
)

type Registry struct {
	mu       sync.Mutex
	journal  *journal
	endpoint string
	runs     []*Run // in the order of submission; a run's number is its place, from 1
	byID     map[string]*Run
	byKey    map[string]*Run // by account and Idempotency-Key
}

func NewRegistry(j *journal, stored []journalRecord, endpoint string) (*Registry, error) {
	reg := &Registry{
		journal: j, endpoint: endpoint, byID: map[string]*Run{}, byKey: map[string]*Run{},
	}
	for _, entry := range stored {
		if entry.Submission != nil {
			if err := reg.restore(*entry.Submission); err != nil {
				return nil, err
			}
		}
		if entry.Change != nil {
			reg.byID[entry.Change.Run].replay(entry.Change)
		}
	}
	// No session outlives its server: what was in play is played again and counts no
	// attempt (CRASH-002).
	for _, r := range reg.runs {
		r.wake()
		if r.state == queued {
			r.alarm()
		}
	}
	return reg, nil
}

func (reg *Registry) restore(s submission) error {
	body, err := wire.ParseJSON(s.Body)
	if err != nil {
		return err
	}
	r, p := newRun(s, body.(map[string]any), reg.endpoint)
	if p != nil {
		return fmt.Errorf("run %s: %s", s.ID, p.Detail)
	}
	reg.add(r)
	return nil
}

func (reg *Registry) add(r *Run) {
	r.journal = reg.journal
	reg.runs = append(reg.runs, r)
	reg.byID[r.ID] = r
	if r.Key != "" {
		reg.byKey[r.Account+"\x00"+r.Key] = r
	}
}

// Submit makes a run, or gives the one that the key has made (RUN-003, RUN-005).
func (reg *Registry) Submit(account, key string, body map[string]any) (*Run, *wire.Problem) {
	reg.mu.Lock()
	defer reg.mu.Unlock()
	if first := reg.byKey[account+"\x00"+key]; key != "" && first != nil {
		if first.digest != wire.Digest(body) { // RUN-004
			return nil, wire.Refuse("idempotency_conflict", "RUN-004", "Use a new key for a new request.")
		}
		return first, nil
	}
	s := submission{
		ID: "run_" + strings.ToLower(rand.Text()), Number: len(reg.runs) + 1,
		Account: account, Key: key, Created: time.Now(),
		Body: json.RawMessage(wire.AppendJSON(nil, wire.Plain(body))),
	}
	r, p := newRun(s, body, reg.endpoint)
	if p != nil {
		return nil, p
	}
	reg.add(r)
	r.mu.Lock()
	defer r.mu.Unlock()
	r.enqueue()
	r.commit(journalRecord{Submission: &s})
	return r, nil
}

// Find does not show the runs of another account (AUTH-003, RUN-010).
func (reg *Registry) Find(account, id string) (*Run, *wire.Problem) {
	reg.mu.Lock()
	defer reg.mu.Unlock()
	if r := reg.byID[id]; r != nil && r.Account == account {
		return r, nil
	}
	return nil, wire.Refuse("not_found", "RUN-010", "There is no such run for this caller.")
}

// Page gives the account's runs, newest first, behind a cursor (RUN-009, AUTH-004).
func (reg *Registry) Page(account, cursor string, limit int) ([]*Run, string, *wire.Problem) {
	reg.mu.Lock()
	defer reg.mu.Unlock()
	from, p := readCursor(cursor, len(reg.runs), len(reg.runs))
	if p != nil {
		return nil, "", p
	}
	page := []*Run{}
	for i := from; i > 0; i-- {
		r := reg.runs[i-1]
		if r.Account != account {
			continue
		}
		if len(page) == limit {
			return page, strconv.Itoa(i), nil
		}
		page = append(page, r)
	}
	return page, "", nil
}

// readCursor gives the place where a page begins: a number that this server wrote.
func readCursor(cursor string, absent, last int) (int, *wire.Problem) {
	if cursor == "" {
		return absent, nil
	}
	place, err := strconv.Atoi(cursor)
	if err != nil || place < 0 || place > last {
		return 0, wire.RefuseAt("invalid_request", "", "query:cursor", "is no cursor of this server")
	}
	return place, nil
}
