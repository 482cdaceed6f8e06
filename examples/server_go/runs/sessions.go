// Sessions of workers: attach, takeover, lease, heartbeat, detach, and why a session is
// refused. Turns are in turns.go. Everything here happens under the run's lock.
package runs

import (
	"crypto/rand"
	"fmt"
	"time"

	"proctor-server-go/calibration"
	"proctor-server-go/wire"
)

// session is one attachment of a worker. While it is not done it holds a slot and an
// episode; when it is done it holds neither, and its last turn can be repeated until its
// lease ends.
type session struct {
	id, worker string
	endedBy    string // what ended it; empty while it lives
	superseded bool
	gone       chan struct{} // closed when the session is not live any more
	done       bool
	episode    *episode
	sim        calibration.Simulator
	seq        int64
	digest     [32]byte // of the body of the last predict
	turn       wire.Object
	flight     *flight
	deadline   time.Time
	timer      *time.Timer
	answered   time.Time     // when the last turn was answered
	think      time.Duration // of this attempt, between turns
}

func (s *session) live() bool { return s.endedBy == "" && !s.superseded }

// find gives a live session of the worker, or says why there is none. A session that this
// process never had may be one from before a restart.
func (r *Run) find(worker, id string) (*session, *wire.Problem) {
	s := r.sessions[id]
	if s == nil || s.worker != worker {
		return nil, r.refuseEnded("unknown", "LEASE-001")
	}
	if p := r.refusal(s); p != nil {
		return nil, p
	}
	return s, nil
}

func (r *Run) refusal(s *session) *wire.Problem {
	if s.superseded { // ATT-005
		return wire.Refuse("session_superseded", "ATT-005", "Another session has taken this worker over.")
	}
	rules := map[string]string{
		"lease_ended": "LEASE-001", "run_stopped": "STOP-002", "run_failed": "FAULT-006",
	}
	if s.endedBy != "" {
		return r.refuseEnded(s.endedBy, rules[s.endedBy])
	}
	return nil
}

func (r *Run) refuseEnded(endedBy, rule string) *wire.Problem {
	p := wire.Refuse("session_ended", rule, "The session is not live any more; attach again.")
	p.EndedBy, p.State = endedBy, r.state
	return p
}

// extend gives the session its whole lease from now on (LEASE-003, LEASE-004).
func (r *Run) extend(s *session) wire.Object {
	idle := seconds(r.idleS)
	s.deadline = time.Now().Add(idle)
	if s.timer == nil {
		s.timer = time.AfterFunc(idle, r.wake)
	} else {
		s.timer.Reset(idle)
	}
	return wire.Object{{"expires_at", Stamp(s.deadline)}, {"idle_timeout_s", r.idleS}}
}

// end ends a live session, and the attempt that it plays.
func (r *Run) end(s *session, why string, counted bool) {
	if !s.live() {
		return
	}
	s.endedBy = why
	r.drop(s)
	if s.episode != nil {
		r.close(s, counted) // LEASE-006, DET-001
	}
}

func (r *Run) drop(s *session) {
	close(s.gone)
	s.timer.Stop()
}

// Attach is `attach_worker` with a body that its schema allows.
func (r *Run) Attach(
	worker string, body map[string]any, watch *calibration.Stopwatch,
) (wire.Object, *wire.Problem) {
	key := worker + "\x00" + body["attach_key"].(string)
	if s := r.keys[key]; s != nil && s.live() { // ATT-002
		r.extend(s)
		return s.turn, nil
	}
	if p := r.command(commandAttach); p != nil {
		return nil, p
	}
	assumes, _ := body["assumes"].(map[string]any)
	if found := contradictions(assumes); found != nil { // ATT-010
		return nil, &wire.Problem{Code: "convention_mismatch", Rule: "ATT-010", Faults: found,
			Detail: "The benchmark contradicts what the policy assumes."}
	}
	held := r.holders[worker]
	if takeover, _ := body["takeover"].(bool); held != nil && !takeover { // ATT-003, ATT-008
		return nil, wire.Refuse("worker_busy", "ATT-003", "The worker has a live session.")
	}
	if held == nil && len(r.holders) >= r.workers { // ATT-006, ATT-007
		return nil, wire.Refuse("worker_limit", "ATT-006", "All workers of the run are live.")
	}
	s := &session{id: "session_" + rand.Text() + rand.Text(), worker: worker,
		gone: make(chan struct{})} // ATT-009: 260 random bits
	r.sessions[s.id], r.keys[key] = s, s
	if held != nil { // ATT-004
		s.episode, s.sim, s.think = held.episode, held.sim, held.think
		held.episode, held.superseded = nil, true
		r.drop(held)
		r.holders[worker] = s
	} else {
		r.handOut(s)
	}
	if r.state == ready {
		r.fire(commandAttach)
	}
	r.commit()
	return r.answerTurn(s, played{}, watch), nil
}

// handOut gives the session its next episode. Without one it is done (ATT-012, PRED-009).
func (r *Run) handOut(s *session) {
	delete(r.holders, s.worker)
	s.episode, s.think = nil, 0
	if r.state != stopping { // STOP-004
		s.episode = r.nextPending()
	}
	if s.done = s.episode == nil; !s.done {
		s.episode.inPlay = true
		s.sim = calibration.NewSimulator(s.episode.task)
		r.holders[s.worker] = s
	}
}

// contradictions points at each assumption that the benchmark does not confirm.
func contradictions(assumes map[string]any) []wire.Fault {
	found := &wire.Findings{}
	if rate, given := assumes["control_rate_hz"]; given && rate != calibration.ControlRate {
		found.Add("/assumes/control_rate_hz", "the benchmark says 10")
	}
	for part, spaces := range map[string][]calibration.VectorSpace{
		"action": calibration.ActionSpace, "state": calibration.StateSpace,
	} {
		entries, _ := assumes[part].(map[string]any)
		for _, name := range wire.SortedKeys(entries) {
			at := wire.PointTo("/assumes/"+part, name)
			space := spaceNamed(spaces, name)
			if space == nil {
				found.Add(at, "the benchmark has no such entry")
				continue
			}
			assumption := entries[name].(map[string]any)
			compareMembers(found, at, assumption, space)
			parts, _ := assumption["parts"].(map[string]any)
			for _, name := range wire.SortedKeys(parts) {
				partAt := wire.PointTo(at+"/parts", name)
				if name != calibration.PartName {
					found.Add(partAt, "the vector has no such part")
					continue
				}
				compareMembers(found, partAt, parts[name].(map[string]any), space)
			}
		}
	}
	return found.Faults
}

// compareMembers compares what is assumed of the only part of a vector. Beside `parts` it is
// about each part (CONV-004).
func compareMembers(found *wire.Findings, at string, assumed map[string]any, space *calibration.VectorSpace) {
	for _, member := range wire.SortedKeys(assumed) {
		declared := space.Assumable(member)
		if member != "parts" && declared != assumed[member] {
			found.Add(wire.PointTo(at, member),
				fmt.Sprintf("assumed %v, declared %v in the part %s", assumed[member], declared, calibration.PartName))
		}
	}
}

func spaceNamed(spaces []calibration.VectorSpace, name string) *calibration.VectorSpace {
	for i := range spaces {
		if spaces[i].Name == name {
			return &spaces[i]
		}
	}
	return nil
}

// Heartbeat extends the lease, also while a turn is executed.
func (r *Run) Heartbeat(worker, id string) (wire.Object, *wire.Problem) {
	s, p := r.find(worker, id)
	if p != nil {
		return nil, p // LEASE-008
	}
	return r.extend(s), nil
}

// Detach is quiet about a session that has ended already (DET-002).
func (r *Run) Detach(worker, id string) *wire.Problem {
	s, p := r.find(worker, id)
	if p != nil {
		if p.Code == "session_superseded" && r.holders[worker] != nil {
			return p
		}
		return nil
	}
	r.end(s, "detached", true)
	r.settle()
	r.commit()
	return nil
}
