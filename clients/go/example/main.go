// Plays the benchmark `calibration` with a scripted policy, or goes on with a run:
//
//	PROCTOR_TOKEN=… go run ./example URL [RUN_ID]
package main

import (
	"fmt"
	"os"
	"sync"

	"proctor"
	. "proctor/example/worker"
)

func evaluate(server *Server, runID string) error {
	submit := server.Control.SubmitRun(server.Context).IdempotencyKey(Key()).SubmitRun(proctor.SubmitRun{
		BenchmarkId: "calibration", Policy: proctor.PolicyInfo{Name: "scripted"},
		Options: &proctor.CalibrationOptions{Tasks: []proctor.CalibrationTask{
			"score", "score", "score", "score", "score", "score", "score", "score"}},
	})
	send := submit.Execute
	if runID != "" {
		send = server.Control.ResumeRun(server.Context, runID).Execute
	}
	run, err := Ask(send)
	if err != nil {
		return err
	}
	fmt.Printf("run %s: %d episodes; its id, as RUN_ID, goes on with it\n", run.RunId, run.Progress.EpisodesTotal)
	policy := func(turn *proctor.Turn) []proctor.Action {
		action := Act(float64(turn.Episode.Index%5) / 4)
		return []proctor.Action{action, action, action, action}
	}
	report := func(r *proctor.EpisodeResult) {
		fmt.Printf("  episode %d (%s): %s, score %g\n", r.Index, r.Task, r.Outcome, r.Score)
	}
	var team sync.WaitGroup
	failures := make([]error, 2)
	for i := range failures {
		team.Add(1)
		go func() {
			defer team.Done()
			failures[i] = server.Play(run.RunId, fmt.Sprintf("worker-%d", i), policy, report)
		}()
	}
	team.Wait()
	for _, err := range failures {
		if err != nil {
			return err
		}
	}
	score, err := Ask(server.Control.GetScore(server.Context, run.RunId).Execute)
	if err == nil {
		fmt.Printf("score %g\n", *score.Score.Get())
	}
	return err
}

func main() {
	token := os.Getenv("PROCTOR_TOKEN")
	if token == "" || len(os.Args) != 2 && len(os.Args) != 3 {
		fmt.Fprintf(os.Stderr, "usage: %s URL [RUN_ID]; the token is PROCTOR_TOKEN\n", os.Args[0])
		os.Exit(1)
	}
	arguments := append(os.Args[1:], "")
	server, err := At(arguments[0], token)
	if err == nil {
		err = evaluate(server, arguments[1])
	}
	if err != nil {
		fmt.Fprintf(os.Stderr, "%v\n", err)
		os.Exit(1)
	}
}
