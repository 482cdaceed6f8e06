package worker

import (
	"context"
	"regexp"
	"slices"
	"strings"
	"time"

	"proctor"
)

const (
	reasonTimeout = 3 * time.Second
	reasonMax     = 500
)

var (
	userOfURL  = regexp.MustCompile(`://[^/?#\s]*@`)
	queryOfURL = regexp.MustCompile(`(://[^\s?#]*)[?#][^\s'"<>]*`)
)

// sayWhyLeft lets those who look at the run read why the worker has left its episode, without
// secrets. The session is left to its lease all the same, so a failure is of no matter.
func (s *Server) sayWhyLeft(data *proctor.DataAPIService, runID, workerID string, turn *proctor.Turn, why string) {
	limited, cancel := context.WithTimeout(s.Context, reasonTimeout)
	defer cancel()
	service, err := Once(s.Control.DescribeService(limited).Execute)
	if err != nil || !slices.Contains(service.Profiles, "reasons") {
		return
	}
	if token, _ := s.Context.Value(proctor.ContextAccessToken).(string); token != "" {
		why = strings.ReplaceAll(why, token, "(token)")
	}
	why = queryOfURL.ReplaceAllString(userOfURL.ReplaceAllString(why, "://"), "$1?…")
	characters := []rune(strings.Join(strings.Fields(why), " "))
	if len(characters) > reasonMax {
		characters = append(characters[:reasonMax-1], '…')
	}
	why = string(characters)
	beat := proctor.Heartbeat{SessionId: turn.SessionId, Reason: &why}
	_, _ = Once(data.Heartbeat(limited, runID, workerID).Heartbeat(beat).Execute)
}
