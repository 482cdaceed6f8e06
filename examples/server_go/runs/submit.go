// From the body of `submit_run` to a run: what this server and its benchmark offer.
package runs

import (
	"fmt"
	"math"
	"time"

	"proctor-server-go/calibration"
	"proctor-server-go/wire"
)

// newRun reads a body that its schema allows, and refuses what this server does not offer.
func newRun(s submission, body map[string]any, endpoint string) (*Run, *wire.Problem) {
	options, _ := body["options"].(map[string]any)
	r := &Run{
		submission: s, digest: wire.Digest(body), manifest: calibration.ManifestOf(options),
		policy: body["policy"].(map[string]any), endpoint: endpoint,
		workers: MaxWorkers, idleS: IdleMax, images: calibration.DefaultImages,
		state: queued, touched: map[int]bool{}, sessions: map[string]*session{},
		keys: map[string]*session{}, holders: map[string]*session{},
		changed: make(chan struct{}),
	}
	r.SHA256 = r.manifest.Digest()
	for i, task := range r.manifest.Tasks {
		r.episodes = append(r.episodes, &episode{Index: i, Attempt: 1, task: task})
	}
	if wait, given := options["queue_s"].(float64); given {
		r.queueFor = seconds(wait)
	}
	if faults, rule := r.choose(body); faults != nil {
		return nil, &wire.Problem{Code: "invalid_request", Rule: rule, Faults: faults,
			Detail: "The server or its benchmark does not offer what is asked for."}
	}
	return r, nil
}

// choose takes what the server and the benchmark limit, and gives the faults and the rule
// that was enforced last.
func (r *Run) choose(body map[string]any) ([]wire.Fault, string) {
	found, rule := &wire.Findings{}, ""
	if body["benchmark_id"] != calibration.BenchmarkID {
		rule = "RUN-006"
		found.Add("/benchmark_id", "is no benchmark of this server")
	}
	if workers, given := body["max_workers"].(float64); given {
		if r.workers = int(workers); r.workers > MaxWorkers {
			rule = "RUN-015"
			found.Add("/max_workers", fmt.Sprintf("is above limits.max_workers, %d", MaxWorkers))
		}
	}
	if idle, given := body["idle_timeout_s"].(float64); given {
		if r.idleS = idle; idle < IdleMin || idle > IdleMax {
			rule = "LEASE-007"
			found.Add("/idle_timeout_s", "lies outside the announced limits")
		}
	}
	if choice, given := body["images"].(map[string]any); given {
		r.images = calibration.ImageChoice{
			Codec: choice["codec"].(string),
			Width: int(choice["width"].(float64)), Height: int(choice["height"].(float64)),
		}
		before := len(found.Faults)
		if r.images.Faults(found); len(found.Faults) > before {
			rule = "RUN-017"
		}
	}
	return found.Faults, rule
}

func seconds(s float64) time.Duration { return time.Duration(math.Round(s * 1e9)) }
