// The stream of server-sent events of a run (profile `events`). What an event is, and what
// its id stands for, is decided by the run.
package api

import (
	"io"
	"time"

	"proctor-server-go/runs"
	"proctor-server-go/wire"
)

const keepAlive = 8 * time.Second

func streamEvents(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	at := runs.Place{}
	if id, given := r.values["header:Last-Event-ID"]; given {
		known := false
		if at, known = found.PlaceOf(id); !known {
			return nil, wire.RefuseAt("invalid_request", "EVT-007", "header:Last-Event-ID",
				"is the id of no event of this run")
		}
		if found.Over() && found.IsLast(at) { // EVT-010
			return &answer{status: 204}, nil
		}
	}
	made, _ := ok(nil)
	made.stream = func(w io.Writer, flush func()) { follow(r, found, at, w, flush) }
	return made, nil
}

// follow writes until the run can change no more or the reader has gone.
func follow(r *request, found *runs.Run, at runs.Place, w io.Writer, flush func()) {
	text, silentSince := "retry: 1000\n\n", time.Now()
	for {
		found.Enter()
		more, next := found.EventsAfter(at)
		over, changed := found.Over(), found.Changes()
		found.Leave()
		at = next
		if text+more != "" {
			if _, err := io.WriteString(w, text+more); err != nil {
				return
			}
			flush()
			silentSince = time.Now()
		}
		if over {
			return
		}
		text = ""
		select {
		case <-changed:
		case <-time.After(keepAlive - time.Since(silentSince)): // EVT-008
			text = ": still here\n\n"
		case <-r.http.Context().Done():
			return
		}
	}
}
