// Turns: a chunk of actions in, the next observation out, exactly once. A turn takes its
// seq under the run's lock, is executed on a copy of the simulator without it (PRED-022),
// and has its effect under the lock when it ends.
package runs

import (
	"strconv"
	"time"

	"proctor-server-go/calibration"
	"proctor-server-go/wire"
)

// flight is a turn that is being executed; a repeat of its request waits for it.
type flight struct {
	seq     int64
	digest  [32]byte
	over    chan struct{}
	turn    wire.Object
	refused *wire.Problem
}

// played is what has become of a chunk.
type played struct {
	end          string // one of the step constants
	sim          calibration.Simulator
	rewards      []float64
	observeAll   bool
	observations []wire.Object
	early        bool
	truncated    bool
	result       wire.Object
	fault        wire.Object
}

// Predict is called without the lock, with a body that its schema allows.
func (r *Run) Predict(
	worker string, body map[string]any, watch *calibration.Stopwatch,
) (wire.Object, *wire.Problem) {
	r.Enter()
	s, p := r.find(worker, body["session_id"].(string))
	if p != nil {
		r.Leave()
		return nil, p
	}
	seq, sum := int64(body["seq"].(float64)), wire.Digest(body)
	if f := s.flight; f != nil && f.seq == seq && f.digest == sum { // PRED-005
		r.Leave()
		<-f.over
		return f.turn, f.refused
	}
	if turn, p := r.admit(s, seq, sum); turn != nil || p != nil {
		r.Leave()
		return turn, p
	}
	actions, p := readActions(body["actions"].([]any))
	if p != nil { // PRED-024: the seq is not taken yet
		r.Leave()
		return nil, p
	}
	f := &flight{seq: seq, digest: sum, over: make(chan struct{})}
	s.flight = f
	s.think += max(0, watch.Begun.Sub(s.answered)) // 0 if it came before the answer
	sim := s.sim
	r.Leave()

	outcome := r.execute(sim, actions, body["observe"] == "all", s.gone, watch)

	r.mu.Lock()
	defer r.mu.Unlock()
	s.flight = nil
	f.turn, f.refused = r.apply(s, f, outcome, watch)
	close(f.over)
	return f.turn, f.refused
}

// admit repeats the last turn or refuses a seq; neither means that the turn may begin.
func (r *Run) admit(s *session, seq int64, sum [32]byte) (wire.Object, *wire.Problem) {
	last, expected, lastSum := s.seq, s.seq+1, s.digest
	if s.flight != nil { // its seq is taken
		last, expected, lastSum = s.flight.seq, s.flight.seq, s.flight.digest
	}
	switch {
	case seq == last && sum == lastSum: // PRED-002, PRED-010
		r.extend(s)
		return s.turn, nil
	case seq == last: // PRED-003
		return nil, wire.Refuse("seq_conflict", "PRED-003", "This seq was sent with another body.")
	case seq != expected || s.flight != nil: // PRED-004
		p := wire.Refuse("seq_out_of_order", "PRED-004", "Send expected_seq.")
		p.ExpectedSeq = expected
		return nil, p
	case s.done: // PRED-011
		return nil, wire.Refuse("no_episode", "PRED-011", "The session is done.")
	}
	return nil, nil
}

// readActions refuses the whole chunk for one invalid action (PRED-019).
func readActions(items []any) ([]calibration.Action, *wire.Problem) {
	if len(items) > calibration.MaxChunk { // PRED-015
		return nil, wire.RefuseAt("invalid_request", "PRED-015", "/actions",
			"The chunk is longer than max_chunk, "+strconv.Itoa(calibration.MaxChunk)+".")
	}
	found := &wire.Findings{}
	actions := make([]calibration.Action, len(items))
	for i, item := range items {
		values := item.(map[string]any)["values"].(map[string]any)
		actions[i] = calibration.ReadAction("/actions/"+strconv.Itoa(i)+"/values", values, found)
	}
	if found.Faults != nil {
		return nil, &wire.Problem{Code: "invalid_request", Rule: "PRED-019", Faults: found.Faults,
			Detail: "The action space of the benchmark does not allow this."}
	}
	return actions, nil
}

// execute plays the chunk until it or the episode ends (PRED-001, PRED-006, PRED-007).
func (r *Run) execute(
	sim calibration.Simulator, actions []calibration.Action, all bool, gone <-chan struct{},
	watch *calibration.Stopwatch,
) played {
	made := played{end: calibration.StepExecuted, sim: sim, observeAll: all}
	for i, a := range actions {
		begun := time.Now()
		made.end = made.sim.Step(a, gone)
		watch.Simulate += time.Since(begun)
		if made.end != calibration.StepExecuted {
			return made
		}
		made.rewards = append(made.rewards, a.Score) // PRED-021
		if all {                                     // PRED-012
			made.observations = append(made.observations, calibration.Observe(&made.sim, r.images, watch))
		}
		// PRED-020: a task that ends by itself at the limit is terminated, not truncated.
		made.truncated = !made.sim.Ended && made.sim.Count >= r.manifest.MaxSteps
		if made.sim.Ended || made.truncated {
			made.early = i+1 < len(actions)
			break
		}
	}
	return made
}

// apply lets the turn have its effect, unless the session has ended meanwhile.
func (r *Run) apply(
	s *session, f *flight, made played, watch *calibration.Stopwatch,
) (wire.Object, *wire.Problem) {
	if p := r.refusal(s); p != nil {
		return nil, p
	}
	switch made.end {
	case calibration.StepUnplayable: // FAULT-005
		r.fail("Task "+s.episode.task+" was reported unplayable.", false)
		return nil, r.refusal(s)
	case calibration.StepBroken:
		if r.brokeTooOften(s.episode) {
			r.fail("The simulator of "+episodeID(s.episode.Index)+" broke too often.", true)
			return nil, r.refusal(s) // FAULT-006
		}
		made = r.restart(s, made)
	default:
		s.sim = made.sim
		if made.sim.Ended || made.truncated {
			made.result = r.finish(s, made)
		}
	}
	r.settle()
	r.commit()
	s.seq, s.digest = f.seq, f.digest
	return r.answerTurn(s, made, watch), nil
}

func (r *Run) brokeTooOften(e *episode) bool { // LIFE-806, LIFE-807
	e.Faults++
	e.RecentFaults++
	r.touched[e.Index] = true
	return e.RecentFaults >= r.manifest.MaxFaults
}

// restart begins the same attempt again; nothing of the chunk counts (FAULT-001).
func (r *Run) restart(s *session, made played) played {
	s.sim = calibration.NewSimulator(s.episode.task)
	return played{observeAll: made.observeAll, fault: wire.Object{
		{"episode_id", episodeID(s.episode.Index)}, {"faults", s.episode.Faults},
		{"detail", made.end},
	}}
}

// finish scores the episode and hands out the next one (PRED-008).
func (r *Run) finish(s *session, made played) wire.Object {
	e := s.episode
	outcome := "failure"
	if made.sim.Success(r.manifest.SuccessRule) {
		outcome = "success"
	}
	r.score(e, &result{
		Outcome: outcome, Score: made.sim.Score(r.manifest.SuccessRule), Steps: made.sim.Count,
		Terminated: made.sim.Ended, Truncated: made.truncated, ThinkS: s.think.Seconds(),
	})
	r.handOut(s)
	return e.resultView()
}

// answerTurn stores the session's latest turn; its lease begins with it.
func (r *Run) answerTurn(s *session, made played, watch *calibration.Stopwatch) wire.Object {
	turn := wire.Object{{"session_id", s.id}, {"seq", s.seq}}
	if e := s.episode; e != nil {
		turn = append(turn, wire.Member{"episode", wire.Object{
			{"episode_id", episodeID(e.Index)}, {"index", e.Index}, {"task", e.task},
			{"instruction", "Calibration task " + e.task + "."}, {"attempt", e.Attempt},
			{"step", s.sim.Count}, {"max_steps", r.manifest.MaxSteps},
		}}, wire.Member{"observation", calibration.Observe(&s.sim, r.images, watch)})
	}
	if made.observeAll {
		turn = append(turn, wire.Member{"observations", made.observations})
	}
	turn = append(turn, wire.Object{
		{"executed_steps", len(made.rewards)}, {"stopped_early", made.early}, // PRED-028
		{"rewards", made.rewards}, {"terminated", made.result != nil && made.sim.Ended},
		{"truncated", made.truncated}, {"done", s.done},
	}...)
	if made.result != nil {
		turn = append(turn, wire.Member{"episode_result", made.result})
	}
	if made.fault != nil {
		turn = append(turn, wire.Member{"fault", made.fault})
	}
	s.answered = time.Now()
	s.turn = append(turn, wire.Member{"timing", watch.Timing()}, wire.Member{"lease", r.extend(s)})
	return s.turn
}
