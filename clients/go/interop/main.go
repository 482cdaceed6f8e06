// What the Go client sees: interop SCENARIO URL TOKEN prints one JSON line.
//
// The scenarios are those of tools/interop.py, which judges; nothing is judged here.
package main

import (
	"encoding/base64"
	"encoding/hex"
	"encoding/json"
	"errors"
	"fmt"
	"math"
	"net/http"
	"os"
	"path/filepath"
	"sync"
	"time"

	"proctor"
	. "proctor/example/worker"
)

type (
	seen   = map[string]any
	policy = func(*proctor.Turn) []proctor.Action
)

var vector = []float64{math.Copysign(0, -1), 0.1, 5e-324, math.MaxFloat64, 9007199254740991, 1.0 / 3, -2.5e-8, 1e22}

// must ends the program at what no scenario expects.
func must[T any](value T, err error) T {
	if err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
	return value
}

func ask[T any](send func() (T, *http.Response, error)) T { return must(Ask(send)) }

func repeat[T any](count int, item T) []T {
	items := make([]T, count)
	for i := range items {
		items[i] = item
	}
	return items
}

func with(action proctor.Action, name string, values ...float64) proctor.Action {
	action.Values[name] = values
	return action
}

func submit(s *Server, count int, task proctor.CalibrationTask, maxSteps int32, key string, change func(*proctor.SubmitRun)) *proctor.Run {
	body := proctor.SubmitRun{
		BenchmarkId: "calibration", Policy: proctor.PolicyInfo{Name: "interop"},
		Options: &proctor.CalibrationOptions{Tasks: repeat(count, task), MaxSteps: &maxSteps},
	}
	if change != nil {
		change(&body)
	}
	return ask(s.Control.SubmitRun(s.Context).IdempotencyKey(key).SubmitRun(body).Execute)
}

func attach(s *Server, run *proctor.Run) *proctor.Turn {
	body := proctor.AttachWorker{AttachKey: Key()}
	return ask(must(s.Data(run)).AttachWorker(s.Context, run.RunId, "worker-0").AttachWorker(body).Execute)
}

func chunk(s *Server, run *proctor.Run, turn *proctor.Turn, seq int64, actions ...proctor.Action) proctor.ApiPredictRequest {
	observe := proctor.OBSERVE_ALL
	body := proctor.Predict{SessionId: turn.SessionId, Seq: seq, Actions: actions, Observe: &observe}
	return must(s.Data(run)).Predict(s.Context, run.RunId, "worker-0").Predict(body)
}

func play(s *Server, run *proctor.Run, p policy, workers int) map[string][]*proctor.EpisodeResult {
	results := make([][]*proctor.EpisodeResult, workers)
	var team sync.WaitGroup
	for i := range results {
		team.Add(1)
		go func() {
			defer team.Done()
			report := func(r *proctor.EpisodeResult) { results[i] = append(results[i], r) }
			must(0, s.Play(run.RunId, fmt.Sprintf("worker-%d", i), p, report))
		}()
	}
	team.Wait()
	found := map[string][]*proctor.EpisodeResult{}
	for i, list := range results {
		found[fmt.Sprintf("worker-%d", i)] = list
	}
	return found
}

func byIndex(scores ...float64) policy {
	return func(turn *proctor.Turn) []proctor.Action { return repeat(2, Act(scores[turn.Episode.Index])) }
}

func each[T, U any](items []T, f func(T) U) []U {
	made := make([]U, 0, len(items))
	for _, item := range items {
		made = append(made, f(item))
	}
	return made
}

func theScore(s *Server, run *proctor.Run, more seen) seen {
	score := ask(s.Control.GetScore(s.Context, run.RunId).Execute)
	more["run_id"], more["score"], more["complete"] = run.RunId, score.Score.Get(), score.Complete
	return more
}

func problemOf[T any](send func() (T, *http.Response, error)) seen {
	_, err := Once(send)
	var failure *proctor.Failure
	if !errors.As(err, &failure) || failure.Problem == nil {
		return seen{"code": fmt.Sprint("no refusal: ", err)}
	}
	problem := failure.Problem
	return seen{
		"status": failure.Status, "code": problem.Code, "retryable": problem.Retryable,
		"side_effects": problem.SideEffects, "retry_after_s": failure.RetryAfter.Seconds(),
		"pointers":     each(problem.Errors, func(item proctor.ProblemItem) string { return item.Pointer }),
		"expected_seq": problem.ExpectedSeq, "ended_by": problem.EndedBy,
	}
}

func indices(results []*proctor.EpisodeResult) []int32 {
	return each(results, func(r *proctor.EpisodeResult) int32 { return r.Index })
}

func counts(turn *proctor.Turn) []float64 {
	return each(turn.Observations, func(o proctor.Observation) float64 { return o.State["count"][0] })
}

var scenarios = map[string]func(*Server, string) seen{
	"submit": func(s *Server, _ string) seen {
		key := Key()
		first, second := submit(s, 1, "score", 10, key, nil), submit(s, 1, "score", 10, key, nil)
		listed := 0
		for _, run := range ask(s.Control.ListRuns(s.Context).Limit(1000).Execute).Runs {
			if run.RunId == first.RunId {
				listed++
			}
		}
		sizes := seen{}
		for name, space := range ask(s.Control.GetBenchmark(s.Context, "calibration").Execute).ActionSpace {
			sizes[name] = space.Size
		}
		service := ask(s.Control.DescribeService(s.Context).Execute)
		return seen{"run_ids": []string{first.RunId, second.RunId}, "listed": listed, "max_workers": service.Limits.MaxWorkers, "action_sizes": sizes}
	},
	"two_workers": func(s *Server, _ string) seen {
		run, played := submit(s, 8, "delay", 4, Key(), nil), seen{}
		p := func(turn *proctor.Turn) []proctor.Action {
			return repeat(2, with(Act(float64(turn.Episode.Index%2)), "delay_s", 0.05))
		}
		for worker, results := range play(s, run, p, 2) {
			played[worker] = indices(results)
		}
		return theScore(s, run, seen{"played": played})
	},
	// The policy panics after the first turn, with a text that has a password and the token.
	"left": func(s *Server, _ string) (observed seen) {
		run := submit(s, 1, "count", 10, Key(), nil)
		p := func(turn *proctor.Turn) []proctor.Action {
			if turn.Episode.Step > 0 {
				panic("no answer of\nhttp://me:password@host/?key=k with " + os.Args[3])
			}
			return repeat(1, Act(0))
		}
		defer func() {
			recover()
			observed = seen{"run_id": run.RunId}
		}()
		must(0, s.Play(run.RunId, "worker-0", p, func(*proctor.EpisodeResult) {}))
		return seen{}
	},
	"chunks": func(s *Server, _ string) seen {
		run := submit(s, 1, "count", 10, Key(), nil)
		turn, turns := attach(s, run), []*proctor.Turn{}
		for range 3 {
			turn = ask(chunk(s, run, turn, turn.Seq+1, repeat(4, Act(0))...).Execute)
			turns = append(turns, turn)
		}
		return seen{
			"executed":      each(turns, func(t *proctor.Turn) int32 { return t.ExecutedSteps }),
			"counts":        each(turns, counts),
			"rewards":       each(turns, func(t *proctor.Turn) int { return len(t.Rewards) }),
			"stopped_early": each(turns, func(t *proctor.Turn) bool { return t.StoppedEarly }),
			"truncated":     each(turns, func(t *proctor.Turn) bool { return t.Truncated }),
			"done":          turn.Done, "steps": turn.EpisodeResult.Steps,
		}
	},
	"echo": func(s *Server, _ string) seen {
		run := submit(s, 1, "echo", 10, Key(), func(body *proctor.SubmitRun) {
			body.Images = &proctor.ImageChoice{Codec: "raw", Width: 64, Height: 48}
		})
		turn := attach(s, run)
		look := ask(chunk(s, run, turn, 1, with(Act(0), "vector", vector...)).Execute).Observation
		digits := func(data string) string { return hex.EncodeToString(must(base64.StdEncoding.DecodeString(data))) }
		image, tensors := look.Images["pattern"], seen{}
		for name, tensor := range look.Tensors {
			tensors[name] = seen{"dtype": tensor.Dtype, "shape": tensor.Shape, "data": digits(tensor.Data)}
		}
		return seen{
			"codec": image.Codec, "size": []int32{image.Height, image.Width, image.Channels},
			"image": digits(image.Data), "tensors": tensors,
			"vector": each(look.State["vector"], func(x float64) string { return fmt.Sprintf("%016x", math.Float64bits(x)) }),
		}
	},
	"lost_answer": func(s *Server, _ string) seen {
		run := submit(s, 1, "count", 6, Key(), nil)
		turn, all := attach(s, run), []float64{}
		for range 2 {
			turn = ask(chunk(s, run, turn, turn.Seq+1, repeat(3, Act(0))...).Execute)
			all = append(all, counts(turn)...)
		}
		return seen{"run_id": run.RunId, "counts": all, "done": turn.Done}
	},
	"lost_session": func(s *Server, _ string) seen {
		run := submit(s, 1, "count", 10, Key(), func(body *proctor.SubmitRun) { body.SetIdleTimeoutS(2) })
		calls, sessions := 0, map[string]bool{}
		results := play(s, run, func(turn *proctor.Turn) []proctor.Action {
			calls++
			sessions[turn.SessionId] = true
			for calls == 2 && ask(s.Control.GetRun(s.Context, run.RunId).Execute).LiveWorkers > 0 {
				time.Sleep(100 * time.Millisecond) // thinks for longer than the lease
			}
			return repeat(2, Act(1))
		}, 1)["worker-0"]
		return theScore(s, run, seen{"sessions": len(sessions), "attempt": results[len(results)-1].Attempt})
	},
	"restart": func(s *Server, _ string) seen {
		run := submit(s, 4, "score", 6, Key(), nil)
		results := play(s, run, byIndex(0.25, 0.5, 0.75, 1), 1)["worker-0"]
		return theScore(s, run, seen{"attempts": each(results, func(r *proctor.EpisodeResult) int32 { return r.Attempt })})
	},
	"worker_limit": func(s *Server, _ string) seen {
		run := submit(s, 3, "score", 10, Key(), func(body *proctor.SubmitRun) {
			body.SetMaxWorkers(1)
			body.SetIdleTimeoutS(5)
		})
		turn, data := attach(s, run), must(s.Data(run))
		body := proctor.AttachWorker{AttachKey: "k"}
		problem := problemOf(data.AttachWorker(s.Context, run.RunId, "worker-1").AttachWorker(body).Execute)
		ask(func() (int, *http.Response, error) {
			answer, err := data.DetachWorker(s.Context, run.RunId, "worker-0").SessionId(turn.SessionId).Execute()
			return 0, answer, err
		})
		play(s, run, byIndex(1, 1, 1), 2)
		return theScore(s, run, seen{"problem": problem})
	},
	"stop_resume": func(s *Server, _ string) seen {
		run, p := submit(s, 3, "score", 2, Key(), nil), byIndex(0.5, 0.25, 1)
		turn := attach(s, run)
		turn = ask(chunk(s, run, turn, 1, p(turn)...).Execute)
		stopped := ask(s.Control.StopRun(s.Context, run.RunId).StopRun(proctor.StopRun{Mode: proctor.STOPMODE_ABORT.Ptr()}).Execute)
		problem := problemOf(chunk(s, run, turn, 2, p(turn)...).Execute)
		ask(s.Control.ResumeRun(s.Context, run.RunId).Execute)
		after := indices(play(s, run, p, 1)["worker-0"])
		return theScore(s, run, seen{"problem": problem, "stopped": stopped.State, "after": after})
	},
	"problems": func(s *Server, url string) seen {
		unknown := proctor.SubmitRun{BenchmarkId: "no_such", Policy: proctor.PolicyInfo{Name: "interop"}}
		unauthenticated, run := must(At(url, "not-a-token")), submit(s, 1, "count", 10, Key(), nil)
		turn := attach(s, run)
		return seen{"problems": []seen{
			problemOf(s.Control.SubmitRun(s.Context).SubmitRun(unknown).Execute),
			problemOf(s.Control.GetRun(s.Context, "no_such").Execute),
			problemOf(unauthenticated.Control.ListRuns(unauthenticated.Context).Execute),
			problemOf(chunk(s, run, turn, 1, with(Act(0), "vector", 1)).Execute),
			problemOf(chunk(s, run, turn, 7, Act(0)).Execute),
		}}
	},
	// Every run that is listed is answered by what is no run.
	"wrong_answers": func(s *Server, _ string) seen {
		found := seen{}
		for _, run := range ask(s.Control.ListRuns(s.Context).Execute).Runs {
			_, _, err := s.Control.GetRun(s.Context, run.RunId).Execute()
			var invalid *proctor.GenericOpenAPIError
			switch {
			case err == nil:
				found[run.RunId] = "accepted"
			case errors.As(err, &invalid):
				found[run.RunId] = "bad_answer"
			default:
				must(0, err)
			}
		}
		return seen{"errors": found}
	},
	"later_version": func(s *Server, _ string) seen {
		service := ask(s.Control.DescribeService(s.Context).Execute)
		benchmark := ask(s.Control.GetBenchmark(s.Context, "calibration").Execute)
		vector, run := benchmark.ActionSpace["vector"], submit(s, 1, "echo", 10, Key(), nil)
		look := attach(s, run).Observation
		return seen{
			"profiles": service.Profiles, "image_codecs": service.ImageCodecs, "success_rule": benchmark.SuccessRule,
			"rotation": vector.GetParts()["all"].Rotation, "out_of_range": vector.OutOfRange, "mode": run.Mode, "policy": run.Policy.Name,
			"codec": look.Images["pattern"].Codec, "dtype": look.Tensors["float64"].Dtype,
			"problem": problemOf(s.Control.GetRun(s.Context, "no_such").Execute),
		}
	},
	"score": func(s *Server, _ string) seen {
		run := submit(s, 5, "score", 2, Key(), nil)
		play(s, run, byIndex(1, 0.5, 0.25, 0, 0.25), 1)
		score, splits := ask(s.Control.GetScore(s.Context, run.RunId).Execute), seen{}
		for name, group := range score.BySplit {
			splits[name] = group.Mean.Get()
		}
		request, pages, episodes := s.Control.ListEpisodes(s.Context, run.RunId).Limit(2), 0, []any{}
		for more := true; more; pages++ {
			page := ask(request.Execute)
			for _, e := range page.Episodes {
				episodes = append(episodes, []any{e.Index, e.Result.Score, e.Result.Seed})
			}
			if more = page.NextCursor.Get() != nil; more {
				request = request.Cursor(*page.NextCursor.Get())
			}
		}
		return seen{
			"run_id": run.RunId, "score": score.Score.Get(), "success_rate": score.SuccessRate.Get(),
			"interval": []float64{score.SuccessInterval.Low, score.SuccessInterval.High},
			"success":  score.Counts.Success, "splits": splits, "pages": pages, "episodes": episodes,
		}
	},
}

// vectors decodes each golden vector by the client's models and encodes it again.
func vectors(directory string) seen {
	models := map[string]func() any{
		"Action": func() any { return &proctor.Action{} }, "Image": func() any { return &proctor.Image{} },
		"Predict": func() any { return &proctor.Predict{} }, "Problem": func() any { return &proctor.Problem{} },
		"Tensor": func() any { return &proctor.Tensor{} }, "Turn": func() any { return &proctor.Turn{} },
	}
	found := seen{}
	for _, name := range must(filepath.Glob(filepath.Join(directory, "*.json"))) {
		var file struct {
			Vectors []struct {
				Id, Schema, Json string
				Refused          bool
			}
		}
		must(0, json.Unmarshal(must(os.ReadFile(name)), &file))
		for _, v := range file.Vectors {
			if v.Refused {
				continue // for servers
			}
			model := models[v.Schema]()
			if json.Unmarshal([]byte(v.Json), model) != nil {
				found[v.Id] = "refused"
				continue
			}
			found[v.Id] = string(must(json.Marshal(model)))
		}
	}
	return found
}

func main() {
	scenario, url, token := os.Args[1], os.Args[2], os.Args[3]
	play := func() seen { return scenarios[scenario](must(At(url, token)), url) }
	if scenario == "vectors" { // needs no server
		play = func() seen { return vectors(url) }
	}
	fmt.Println(string(must(json.Marshal(play()))))
}
