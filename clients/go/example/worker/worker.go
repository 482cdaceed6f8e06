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
	"strconv"
	"strings"
	"time"

	"proctor"
)

const retryTimeout = 60 * time.Second

// Refused: the server said no, and Problem says why and what to do.
type Refused struct {
	Status     int
	Problem    proctor.Problem
	RetryAfter time.Duration // 0: not said
	Hint       string        // what to change in the base URL, if that is wrong
}

func (r *Refused) Error() string {
	return fmt.Sprintf("%s [%s]", strings.TrimSpace(r.Problem.Detail+" "+r.Hint), r.Problem.Code)
}

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

// Once sends a request; a refusal becomes *Refused.
func Once[T any](send func() (T, *http.Response, error)) (T, error) {
	value, answer, err := send()
	var failed *proctor.GenericOpenAPIError
	if !errors.As(err, &failed) || answer == nil {
		return value, err
	}
	hint := proctor.Hint(answer)
	if problem, ok := failed.Model().(proctor.Problem); ok {
		seconds, _ := strconv.Atoi(answer.Header.Get("Retry-After"))
		return value, &Refused{answer.StatusCode, problem, time.Duration(seconds) * time.Second, hint}
	}
	if hint != "" {
		return value, &Refused{Status: answer.StatusCode, Problem: proctor.Problem{Detail: answer.Status + ".", Code: "bad_answer"}, Hint: hint}
	}
	return value, err
}

// Ask sends a request until it is answered: a repeat executes nothing twice.
func Ask[T any](send func() (T, *http.Response, error)) (T, error) {
	pause, deadline := 100*time.Millisecond, time.Now().Add(retryTimeout)
	waiting := reportWait()
	defer waiting.end()
	for {
		value, err := Once(send)
		var refused *Refused
		if err == nil || time.Now().After(deadline) || (errors.As(err, &refused) && !refused.Problem.Retryable) {
			return value, err
		}
		waiting.because(err)
		if refused != nil && refused.RetryAfter > 0 {
			time.Sleep(refused.RetryAfter)
		} else {
			time.Sleep(pause)
		}
		pause = min(2*pause, 2*time.Second)
	}
}

// Play plays until no episode is left; a lost session is replaced by a new one.
func (s *Server) Play(runID, workerID string, policy func(*proctor.Turn) []proctor.Action, report func(*proctor.EpisodeResult)) error {
	for {
		err := s.session(runID, workerID, policy, report)
		var refused *Refused
		if !errors.As(err, &refused) {
			return err
		}
		why := refused.Problem
		if why.Code == "illegal_transition" && why.GetState() == proctor.RUNSTATE_COMPLETED {
			return nil // the other workers have played the rest
		}
		if why.Code != "session_ended" || why.GetEndedBy() == "run_stopped" || why.GetEndedBy() == "run_failed" {
			return err
		}
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
	var refused *Refused
	isMisled := !errors.As(err, &refused) || refused.Problem.Code == "bad_answer" || refused.Problem.Code == "not_found"
	if err == nil || !isMisled || run.Endpoint == s.URL {
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
