// Server-sent events of a run (profile `events`). An id names a place in the run's events
// that every reader and every restart knows: `RUN-eN` stands behind the Nth scored episode,
// `RUN-rV` behind version V of the run, which follows as many episodes as it counts.
package runs

import (
	"fmt"
	"strconv"
	"strings"

	"proctor-server-go/wire"
)

// Place is what a reader has received: so many episodes, and the run up to a version.
type Place struct {
	episodes, version int
}

// PlaceOf finds the place behind an id that the run has issued (EVT-005, EVT-007).
func (r *Run) PlaceOf(id string) (Place, bool) {
	mark, ours := strings.CutPrefix(id, r.ID+"-")
	if !ours || len(mark) < 2 {
		return Place{}, false
	}
	n, err := strconv.Atoi(mark[1:])
	if err != nil || strconv.Itoa(n) != mark[1:] || n < 1 {
		return Place{}, false
	}
	switch {
	case mark[0] == 'e' && n <= len(r.scored):
		return Place{n, 0}, true
	case mark[0] == 'r' && n <= len(r.versions):
		return Place{r.versions[n-1], n}, true
	}
	return Place{}, false
}

// EventsAfter gives the text of what a reader at the place has not received: episodes, then
// the run that counts them (EVT-001 to EVT-004).
func (r *Run) EventsAfter(at Place) (string, Place) {
	var out strings.Builder
	send := func(kind, id string, body wire.Object) {
		data := wire.AppendJSON(nil, body)
		fmt.Fprintf(&out, "event: %s\nid: %s-%s\ndata: %s\n\n", kind, r.ID, id, data)
	}
	for ; at.episodes < len(r.scored); at.episodes++ {
		send("episode", fmt.Sprintf("e%d", at.episodes+1), r.episodes[r.scored[at.episodes]].view())
	}
	if version := len(r.versions); at.version < version {
		at.version = version
		send("run", fmt.Sprintf("r%d", version), r.View())
	}
	return out.String(), at
}

// IsLast reports whether nothing has happened behind the place.
func (r *Run) IsLast(at Place) bool { return at.version == len(r.versions) }
