// What clients see of a run: the members of the schemas Run, Episode, EpisodeResult and
// Score. Nothing is decided here.
package runs

import (
	"fmt"
	"strconv"
	"time"

	"proctor-server-go/calibration"
	"proctor-server-go/scoring"
	"proctor-server-go/wire"
)

const timeLayout = "2006-01-02T15:04:05.000000Z"

func Stamp(t time.Time) string { return t.UTC().Format(timeLayout) }

func (r *Run) View() wire.Object {
	retryable, position := any(nil), any(nil)
	if r.state == failed {
		retryable = r.retryable
	}
	if r.state == queued {
		position = 1 // no run waits for another one here (RUN-008)
	}
	total, scored, live := len(r.episodes), len(r.scored), len(r.holders)
	return wire.Object{
		{"run_id", r.ID}, {"state", r.state}, {"reason", wire.OrNull(r.reason)},
		{"retryable", retryable}, {"benchmark_id", calibration.BenchmarkID},
		{"benchmark_version", calibration.BenchmarkVersion}, {"manifest_sha256", r.SHA256},
		{"policy", wire.Plain(r.policy)}, {"mode", "pull"}, {"max_workers", r.workers},
		{"idle_timeout_s", r.idleS}, {"images", r.images.Object()},
		{"endpoint", r.endpoint}, {"queue_position", position}, {"live_workers", live},
		{"progress", wire.Object{ // RUN-014
			{"episodes_total", total}, {"episodes_scored", scored},
			{"episodes_in_progress", live}, {"episodes_pending", total - scored - live},
		}},
		{"created_at", Stamp(r.Created)}, {"updated_at", Stamp(r.updated)},
	}
}

func (r *Run) Etag() string { return fmt.Sprintf(`"%s-%d"`, r.ID, len(r.versions)) }

// Changes is closed when the run has changed.
func (r *Run) Changes() <-chan struct{} { return r.changed }

// Differs reports whether the runs have played different things.
func (r *Run) Differs(other *Run) bool { return r.SHA256 != other.SHA256 }

// Over reports whether the run can change no more (EVT-006).
func (r *Run) Over() bool {
	return r.state == completed || r.state == failed && !r.retryable
}

func episodeID(index int) string { return fmt.Sprintf("episode-%d", index) }

func (e *episode) view() wire.Object {
	status := "pending"
	switch {
	case e.Result != nil:
		status = "scored"
	case e.inPlay:
		status = "in_progress"
	}
	made := wire.Object{
		{"episode_id", episodeID(e.Index)}, {"index", e.Index}, {"task", e.task},
		{"split", calibration.Split(e.Index)}, {"status", status}, {"attempt", e.Attempt},
		{"faults", e.Faults},
	}
	if e.Result != nil {
		made = append(made, wire.Member{"result", e.resultView()})
	}
	return made
}

func (e *episode) resultView() wire.Object {
	res := e.Result
	return wire.Object{
		{"episode_id", episodeID(e.Index)}, {"index", e.Index}, {"task", e.task},
		{"split", calibration.Split(e.Index)}, {"seed", calibration.FirstSeed + e.Index},
		{"attempt", res.Attempt},
		{"faults", e.Faults}, {"outcome", res.Outcome}, {"score", res.Score},
		{"steps", res.Steps}, {"terminated", res.Terminated}, {"truncated", res.Truncated},
		{"think_s", res.ThinkS}, {"finished_at", Stamp(res.Finished)},
	}
}

// Page gives episodes behind a cursor, in manifest order (EPI-006).
func (r *Run) Page(cursor string, limit int) ([]wire.Object, string, *wire.Problem) {
	total := len(r.episodes)
	from, p := readCursor(cursor, 0, total)
	if p != nil {
		return nil, "", p
	}
	to, views := min(from+limit, total), []wire.Object{}
	for _, e := range r.episodes[from:to] {
		views = append(views, e.view())
	}
	if to < total {
		return views, strconv.Itoa(to), nil
	}
	return views, "", nil
}

func (r *Run) Graded() []scoring.Graded {
	made := make([]scoring.Graded, len(r.episodes))
	for i, e := range r.episodes {
		made[i] = scoring.Graded{Task: e.task, Split: calibration.Split(i)}
		if e.Result != nil {
			made[i].Outcome, made[i].Score = e.Result.Outcome, e.Result.Score
		}
	}
	return made
}

func (r *Run) ScoreView() wire.Object {
	return append(wire.Object{
		{"run_id", r.ID}, {"benchmark_id", calibration.BenchmarkID},
		{"manifest_sha256", r.SHA256}, {"state", r.state},
	}, scoring.ScoreOf(r.Graded())...)
}
