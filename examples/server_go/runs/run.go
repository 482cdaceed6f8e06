// A run: its state, its episodes and what ends an attempt. Everything here happens under
// the run's lock; `commit` stores what has changed and wakes those who wait for it.
// Sessions and turns are in sessions.go and turns.go; HTTP is not known here.
package runs

import (
	"fmt"
	"maps"
	"slices"
	"sync"
	"time"

	"proctor-server-go/calibration"
	"proctor-server-go/wire"
)

// Limits of a run that describe_service announces.
const (
	MaxWorkers = 64
	IdleMin    = 1.0 // seconds
	IdleMax    = 3600.0
)

// result is that of a scored episode.
type result struct {
	Attempt    int       `json:"attempt"`
	Outcome    string    `json:"outcome"`
	Score      float64   `json:"score"`
	Steps      int       `json:"steps"`
	Terminated bool      `json:"terminated"`
	Truncated  bool      `json:"truncated"`
	ThinkS     float64   `json:"think_s"`
	Finished   time.Time `json:"finished"`
}

// episode is one entry of the manifest with what has become of it. RecentFaults counts
// since the run was last queued.
type episode struct {
	Index        int     `json:"index"`
	Attempt      int     `json:"attempt"`
	Faults       int     `json:"faults"`
	RecentFaults int     `json:"recent_faults"`
	Result       *result `json:"result,omitempty"`
	task         string
	inPlay       bool
}

// view holds the members of schema Run that change; its ETag changes with it.
type view struct {
	State     string `json:"state"`
	Reason    string `json:"reason"`
	Retryable bool   `json:"retryable"`
	Live      int    `json:"live"`
	Scored    int    `json:"scored"`
}

type Run struct {
	submission
	digest   [32]byte
	manifest calibration.Manifest
	policy   map[string]any
	workers  int
	idleS    float64
	images   calibration.ImageChoice
	queueFor time.Duration
	endpoint string
	SHA256   string // of the manifest

	mu        sync.Mutex
	journal   *journal
	state     string
	reason    string
	retryable bool
	readyAt   time.Time
	episodes  []*episode
	scored    []int // indices of the scored episodes, in the order of scoring
	touched   map[int]bool
	sessions  map[string]*session // by id, also ended ones
	keys      map[string]*session // by worker and attach_key
	holders   map[string]*session // by worker: those that hold a slot and an episode

	shown     view
	updated   time.Time
	versions  []int // number of scored episodes at each version of the view
	changed   chan struct{}
	queueWake *time.Timer
}

// Enter locks the run and lets happen what time has brought: leases that end, a queue that
// is over.
func (r *Run) Enter() {
	r.mu.Lock()
	now := time.Now()
	for _, s := range r.sessions {
		if s.live() && s.flight == nil && !now.Before(s.deadline) { // LEASE-001, LEASE-005
			r.end(s, "lease_ended", true)
		}
	}
	if r.state == queued && !now.Before(r.readyAt) {
		r.fire(eventCapacity)
	}
	r.settle()
	r.commit()
}

func (r *Run) Leave() { r.mu.Unlock() }

// wake is called by timers.
func (r *Run) wake() {
	r.Enter()
	r.Leave()
}

func (r *Run) fire(event string) {
	r.state, r.reason = next(r.state, event, r.retryable).to, ""
}

// command refuses what the table refuses, without a change.
func (r *Run) command(name string) *wire.Problem {
	move := next(r.state, name, r.retryable)
	if move.to != refused {
		return nil
	}
	p := wire.Refuse("illegal_transition", move.rule, fmt.Sprintf(
		"A run that is %s does not allow %s.", r.state, name))
	p.State = r.state
	return p
}

// settle moves a run that has nothing in play any more.
func (r *Run) settle() {
	switch {
	case r.state != running && r.state != stopping:
	case len(r.scored) == len(r.episodes):
		r.fire(eventScored)
	case len(r.holders) == 0:
		r.fire(eventIdle)
	}
}

// commit stores what has changed, then shows it.
func (r *Run) commit(before ...journalRecord) {
	seen := view{r.state, r.reason, r.retryable, len(r.holders), len(r.scored)}
	visible := seen != r.shown
	if !visible && len(r.touched) == 0 {
		return
	}
	if visible {
		r.shown, r.updated = seen, time.Now()
		r.versions = append(r.versions, len(r.scored))
	}
	entry := &change{
		Run: r.ID, View: seen, Visible: visible, Updated: r.updated, ReadyAt: r.readyAt,
	}
	// Scored episodes first and in their order, which the events repeat.
	for _, index := range append(slices.Clone(r.scored), slices.Sorted(maps.Keys(r.touched))...) {
		if r.touched[index] {
			entry.Episodes = append(entry.Episodes, *r.episodes[index])
			delete(r.touched, index)
		}
	}
	r.journal.append(append(before, journalRecord{Change: entry})...)
	close(r.changed)
	r.changed = make(chan struct{})
}

// replay applies a change that was stored.
func (r *Run) replay(c *change) {
	r.state, r.reason, r.retryable = c.View.State, c.View.Reason, c.View.Retryable
	r.shown, r.updated, r.readyAt = c.View, c.Updated, c.ReadyAt
	for _, stored := range c.Episodes {
		known := r.episodes[stored.Index]
		if stored.Result != nil && known.Result == nil {
			r.scored = append(r.scored, stored.Index)
		}
		stored.task = known.task
		*known = stored
	}
	if c.Visible {
		r.versions = append(r.versions, c.View.Scored)
	}
}

// enqueue puts the run in the queue, from which time releases it (LIFE-801).
func (r *Run) enqueue() {
	r.readyAt = time.Now().Add(r.queueFor)
	for _, e := range r.episodes {
		if e.RecentFaults > 0 {
			e.RecentFaults = 0
			r.touched[e.Index] = true
		}
	}
	if r.queueFor == 0 {
		r.fire(eventCapacity)
		return
	}
	r.alarm()
}

func (r *Run) alarm() {
	if r.queueWake != nil {
		r.queueWake.Stop()
	}
	r.queueWake = time.AfterFunc(time.Until(r.readyAt), r.wake)
}

// Stop is `stop_run`; drain waits for the episodes in play.
func (r *Run) Stop(drain bool) *wire.Problem {
	name := commandAbort
	if drain {
		name = commandDrain
	}
	if p := r.command(name); p != nil {
		return p
	}
	to := next(r.state, name, r.retryable).to
	if !drain {
		for _, s := range r.sessions { // STOP-001, STOP-002
			r.end(s, "run_stopped", true)
		}
	}
	if len(r.scored) == len(r.episodes) {
		r.fire(eventScored) // the last attempt was abandoned by the stop
	} else if r.state != to {
		r.state, r.reason = to, "Stopped by stop_run."
	}
	r.commit()
	return nil
}

func (r *Run) Resume() *wire.Problem {
	if p := r.command(commandResume); p != nil {
		return p
	}
	if to := next(r.state, commandResume, r.retryable).to; to != r.state { // RES-001, RES-002
		r.state, r.reason, r.retryable = to, "", false
		r.enqueue()
	}
	r.commit()
	return nil
}

// fail ends every session (FAULT-014). The simulator is the cause, so that no attempt counts.
func (r *Run) fail(reason string, retryable bool) {
	for _, s := range r.sessions {
		r.end(s, "run_failed", false)
	}
	r.fire(eventFault)
	r.reason, r.retryable = reason, retryable // FAULT-002, FAULT-005, FAULT-015
	r.commit()
}

// nextPending is the first episode that may be handed out (EPI-001, EPI-008).
func (r *Run) nextPending() *episode {
	for _, e := range r.episodes {
		if e.Result == nil && !e.inPlay {
			return e
		}
	}
	return nil
}

// close ends an attempt without a result.
func (r *Run) close(s *session, counted bool) {
	e, steps := s.episode, s.sim.Count
	s.episode, e.inPlay = nil, false
	delete(r.holders, s.worker)
	switch {
	case !counted || steps == 0: // EPI-002
	case e.Attempt == r.manifest.MaxAttempts: // EPI-004
		r.score(e, &result{Outcome: "abandoned", Steps: steps, ThinkS: s.think.Seconds()})
	default: // EPI-003
		e.Attempt++
		r.touched[e.Index] = true
	}
}

// score gives the episode its only result (EPI-005).
func (r *Run) score(e *episode, made *result) {
	made.Attempt, made.Finished = e.Attempt, time.Now()
	e.Result, e.inPlay = made, false
	r.scored = append(r.scored, e.Index)
	r.touched[e.Index] = true
}
