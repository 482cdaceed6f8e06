// Package worker is a loop on the generated client: the least that a policy needs to be
// evaluated. The same loop stands in the example of every language.
package worker

import (
	"context"
	"crypto/rand"
	"encoding/hex"
	"errors"
	"fmt"
	"net/http"
	"os"
	"time"

	"proctor"
)

const retryTimeout = 60 * time.Second

// Server is the control plane of one server, and the data planes that its runs name.
type Server struct {
	URL     string
	Control *proctor.ControlAPIService
	Context context.Context
}

func At(url, token string) (*Server, error) {
	client, auth, err := proctor.Connect(url, token)
	if err != nil {
		return nil, err
	}
	return &Server{url, client.ControlAPI, auth}, nil
}

func (s *Server) Data(run *proctor.Run) (*proctor.DataAPIService, error) {
	client, _, err := proctor.Connect(run.Endpoint, "") // the token is in the context
	if err != nil {
		return nil, fmt.Errorf("the endpoint of the run: %w", err)
	}
	return client.DataAPI, nil
}

// Once sends a request; an error is a *proctor.Failure.
func Once[T any](send func() (T, *http.Response, error)) (T, error) {
	value, answer, err := send()
	return value, proctor.FailureOf(answer, err)
}

// Ask sends a request until it is answered: a repeat executes nothing twice.
func Ask[T any](send func() (T, *http.Response, error)) (T, error) {
	pause, deadline := 100*time.Millisecond, time.Now().Add(retryTimeout)
	waiting := reportWait()
	defer waiting.end()
	for {
		value, err := Once(send)
		var failure *proctor.Failure
		if !errors.As(err, &failure) || !failure.MayRepeat {
			return value, err
		}
		wait := max(pause, failure.RetryAfter)
		if time.Now().Add(wait).After(deadline) {
			return value, err
		}
		waiting.because(err)
		time.Sleep(wait)
		pause = min(2*pause, 2*time.Second)
	}
}

// Play plays until no episode is left; a lost session is replaced by a new one.
func (s *Server) Play(runID, workerID string, policy func(*proctor.Turn) []proctor.Action, report func(*proctor.EpisodeResult)) error {
	for {
		err := s.session(runID, workerID, policy, report)
		var failure *proctor.Failure
		if !errors.As(err, &failure) || failure.Problem == nil {
			return err
		}
		why := failure.Problem
		if why.Code == "illegal_transition" && why.GetState() == proctor.RUNSTATE_COMPLETED {
			return nil // the other workers have played the rest
		}
		if why.Code != "session_ended" || why.GetEndedBy() == "run_stopped" || why.GetEndedBy() == "run_failed" {
			return err
		}
		fmt.Fprintf(os.Stderr, "warning: %s lost its session, and the attempt of an episode that had begun: %v\n", workerID, err)
	}
}

func (s *Server) session(runID, workerID string, policy func(*proctor.Turn) []proctor.Action, report func(*proctor.EpisodeResult)) error {
	run, err := s.untilOpen(runID)
	if err != nil {
		return err
	}
	data, err := s.Data(run)
	if err != nil {
		return err
	}
	key := proctor.AttachWorker{AttachKey: Key()}
	turn, err := Ask(data.AttachWorker(s.Context, runID, workerID).AttachWorker(key).Execute)
	err = s.atEndpoint(run, err)
	defer func() {
		if cause := recover(); cause != nil { // the policy panicked; its episode says so
			s.sayWhyLeft(data, runID, workerID, turn, fmt.Sprintf("The policy panicked: %v", cause))
			panic(cause)
		}
	}()
	for err == nil && !turn.Done {
		chunk := proctor.Predict{SessionId: turn.SessionId, Seq: turn.Seq + 1, Actions: policy(turn)}
		turn, err = Ask(data.Predict(s.Context, runID, workerID).Predict(chunk).Execute)
		err = s.atEndpoint(run, err)
		if err == nil && turn.EpisodeResult != nil {
			report(turn.EpisodeResult)
		}
	}
	return err
}

// atEndpoint says where a request of the data plane was sent, if that may be the fault.
func (s *Server) atEndpoint(run *proctor.Run, err error) error {
	var failure *proctor.Failure
	isMisled := errors.As(err, &failure) && (failure.Problem == nil || failure.Problem.Code == "not_found")
	if !isMisled || run.Endpoint == s.URL {
		return err
	}
	return fmt.Errorf("%w. %s is the endpoint of the run, which %s has named. If clients reach the server elsewhere, its operator sets --public-url",
		err, run.Endpoint, s.URL)
}

// untilOpen returns the run as soon as workers may attach.
func (s *Server) untilOpen(runID string) (*proctor.Run, error) {
	for {
		run, err := Ask(s.Control.GetRun(s.Context, runID).Execute)
		if err != nil || run.State != proctor.RUNSTATE_QUEUED {
			return run, err
		}
		time.Sleep(100 * time.Millisecond)
	}
}

// Key is a name that is not in use.
func Key() string {
	random := make([]byte, 16)
	_, _ = rand.Read(random) // never fails
	return hex.EncodeToString(random)
}
