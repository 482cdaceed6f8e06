// The operations of openapi.yaml: their paths, parameters, media types and handlers. A
// handler has a checked request and calls what decides; it decides nothing itself.
package api

import (
	"net/http"
	"net/url"
	"regexp"
	"slices"
	"strconv"
	"strings"
	"time"
	"unicode/utf8"

	"proctor-server-go/calibration"
	"proctor-server-go/runs"
	"proctor-server-go/scoring"
	"proctor-server-go/wire"
)

// The limits that describe_service announces.
const (
	maxBodyBytes = 8 << 20
	waitMax      = 60
	pageSize     = 100
)

// parameter is one of the query or of the headers; fits is its schema.
type parameter struct {
	in, name string
	required bool
	fits     func(string) bool
}

var (
	versionPattern = regexp.MustCompile(`^[0-9]{1,4}\.[0-9]{1,4}$`)
	cursorPattern  = regexp.MustCompile(`^[A-Za-z0-9_-]{1,128}$`)
	numberPattern  = regexp.MustCompile(`^-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?$`)
	runsPattern    = regexp.MustCompile(`^[A-Za-z0-9_-]{1,64}(,[A-Za-z0-9_-]{1,64}){0,15}$`)
	keyPattern     = regexp.MustCompile(`^[\x21-\x7e]{1,128}$`)
	preferPattern  = regexp.MustCompile(`^wait=[0-9]{1,4}$`)
	limitPattern   = regexp.MustCompile(`^[0-9]{1,9}$`)
)

func limitFits(value string) bool {
	limit, _ := strconv.Atoi(value)
	return limitPattern.MatchString(value) && limit >= 1 && limit <= 1000
}

func toleranceFits(value string) bool {
	tolerance, err := strconv.ParseFloat(value, 64)
	return numberPattern.MatchString(value) && err == nil && tolerance >= 0 && tolerance <= 1
}

func lengthFits(shortest, longest int) func(string) bool {
	return func(value string) bool {
		length := utf8.RuneCountInString(value)
		return length >= shortest && length <= longest
	}
}

var (
	cursor      = parameter{"query", "cursor", false, cursorPattern.MatchString}
	limit       = parameter{"query", "limit", false, limitFits}
	workerID    = parameter{"path", "worker_id", true, idPattern.MatchString}
	lastEventID = parameter{"header", "Last-Event-ID", false, cursorPattern.MatchString}
)

// readParameters adds the parameters to the values, or refuses (ERR-014, ATT-013).
func readParameters(wanted []parameter, r *http.Request, values map[string]string) *wire.Problem {
	query := queryValues(r.URL.RawQuery)
	found := &wire.Findings{}
	for _, p := range wanted {
		name := p.in + ":" + p.name
		switch p.in {
		case "query":
			if given, there := query[p.name]; there {
				values[name] = strings.Join(given, "&") // given twice, it fits nothing
			}
		case "header":
			if given, there := r.Header[http.CanonicalHeaderKey(p.name)]; there {
				values[name] = strings.Join(given, ", ")
			}
		}
		if value, there := values[name]; there && !p.fits(value) || !there && p.required {
			found.Add(name, "is missing or breaks its schema")
		}
	}
	if found.Faults == nil {
		return nil
	}
	return &wire.Problem{Code: "invalid_request", Rule: "ERR-014", Faults: found.Faults,
		Detail: "A parameter breaks its schema."}
}

type path struct {
	segments []string
	methods  map[string]operation
}

var onlyJSON = []string{mediaJSON}
var bothMedia = []string{mediaJSON, mediaMsgpack}

func bare(handle func(*request) (*answer, *wire.Problem), parameters ...parameter) operation {
	return operation{parameters: parameters, produces: onlyJSON, handle: handle}
}

func post(body wire.Shape, media []string, handle func(*request) (*answer, *wire.Problem),
	parameters ...parameter) operation {
	return operation{
		parameters: parameters, produces: media, consumes: media, body: body, handle: handle,
	}
}

var paths []path

func init() {
	describe := bare(describeService)
	describe.public = true // SVC-001
	events := bare(streamEvents, lastEventID)
	events.produces = []string{mediaEvents}
	detach := operation{handle: detachWorker, parameters: []parameter{
		workerID, {"query", "session_id", true, lengthFits(1, 128)}}}
	worker := "/v1/runs/{run_id}/workers/{worker_id}"
	add := func(template string, methods map[string]operation) {
		paths = append(paths, path{strings.Split(template, "/")[1:], methods})
	}
	add("/v1", map[string]operation{"GET": describe})
	add("/v1/benchmarks", map[string]operation{"GET": bare(listBenchmarks)})
	add("/v1/benchmarks/{benchmark_id}", map[string]operation{"GET": bare(getBenchmark)})
	add("/v1/runs", map[string]operation{
		"GET": bare(listRuns, cursor, limit),
		"POST": post(submitShape, onlyJSON, submitRun,
			parameter{"header", "Idempotency-Key", false, keyPattern.MatchString}),
	})
	add("/v1/runs/{run_id}", map[string]operation{"GET": bare(getRun,
		parameter{"header", "If-None-Match", false, lengthFits(0, 200)},
		parameter{"header", "Prefer", false, preferPattern.MatchString})})
	add("/v1/runs/{run_id}/stop", map[string]operation{"POST": post(stopShape, onlyJSON, stopRun)})
	add("/v1/runs/{run_id}/resume", map[string]operation{"POST": bare(resumeRun)})
	add("/v1/runs/{run_id}/episodes", map[string]operation{"GET": bare(listEpisodes, cursor, limit)})
	add("/v1/runs/{run_id}/events", map[string]operation{"GET": events})
	add("/v1/runs/{run_id}/score", map[string]operation{"GET": bare(getScore)})
	add("/v1/comparisons", map[string]operation{"GET": bare(compareRuns,
		parameter{"query", "baseline", true, idPattern.MatchString},
		parameter{"query", "runs", true, runsPattern.MatchString},
		parameter{"query", "tolerance", false, toleranceFits})})
	add(worker, map[string]operation{
		"PUT": post(attachShape, bothMedia, attachWorker, workerID), "DELETE": detach,
	})
	add(worker+"/predict", map[string]operation{
		"POST": post(predictShape, bothMedia, predict, workerID)})
	add(worker+"/heartbeat", map[string]operation{
		"POST": post(heartbeatShape, onlyJSON, heartbeat, workerID)})
}

// route finds the path and the values of its parameters.
func route(escaped string) (map[string]operation, map[string]string) {
	segments := strings.Split(escaped, "/")[1:]
	for _, p := range paths {
		if len(p.segments) != len(segments) {
			continue
		}
		values := map[string]string{}
		fits := true
		for i, wanted := range p.segments {
			value, err := url.PathUnescape(segments[i])
			if err != nil || value == "" {
				fits = false
			} else if name, isParameter := strings.CutPrefix(wanted, "{"); isParameter {
				values["path:"+strings.TrimSuffix(name, "}")] = value
			} else if value != wanted {
				fits = false
			}
		}
		if fits {
			return p.methods, values
		}
	}
	return nil, nil
}

var profiles = []string{
	"core", "sessions", "control", "faults", "accounts", "submit_once", "lists", "waiting",
	"observations", "conventions", "strict_http", "msgpack", "compare", "events",
}

func describeService(*request) (*answer, *wire.Problem) {
	return ok(wire.Object{
		{"name", "Proctor example server in Go"}, {"version", "1.0.0"},
		{"protocol", wire.Object{{"min", protocol}, {"max", protocol}}}, // SVC-002
		{"profiles", profiles},
		{"limits", wire.Object{
			{"max_body_bytes", maxBodyBytes}, {"max_workers", runs.MaxWorkers},
			{"max_chunk", calibration.MaxChunk}, {"idle_timeout_s_min", runs.IdleMin},
			{"idle_timeout_s_max", runs.IdleMax}, {"wait_s_max", waitMax},
		}},
		{"encodings", bothMedia}, {"image_codecs", calibration.CodecNames},
		{"server_time", runs.Stamp(time.Now())},
	})
}

func benchmarkSummary() wire.Object {
	standard := calibration.ManifestOf(nil)
	return wire.Object{
		{"benchmark_id", calibration.BenchmarkID}, {"version", calibration.BenchmarkVersion},
		{"title", "Calibration"},
		{"manifest_sha256", standard.Digest()}, {"episodes_total", len(standard.Tasks)},
	}
}

func listBenchmarks(*request) (*answer, *wire.Problem) {
	return ok(wire.Object{{"benchmarks", []wire.Object{benchmarkSummary()}}}) // BEN-001
}

func getBenchmark(r *request) (*answer, *wire.Problem) {
	if r.values["path:benchmark_id"] != calibration.BenchmarkID { // BEN-002
		return nil, wire.Refuse("not_found", "BEN-002", "There is no such benchmark.")
	}
	rules := calibration.ManifestOf(nil).Rules()
	return ok(append(append(benchmarkSummary(), rules[2:]...), wire.Object{
		{"description", "Needs no physics; for judging servers, not policies."},
		{"unavailable_reason", nil},
	}...))
}

func submitRun(r *request) (*answer, *wire.Problem) {
	made, p := r.Registry.Submit(r.account, r.values["header:Idempotency-Key"], r.body)
	if p != nil {
		return nil, p
	}
	made.Enter()
	defer made.Leave()
	location := http.Header{"Location": {"/v1/runs/" + made.ID}}
	return &answer{status: 201, header: location, body: made.View()}, nil // RUN-001
}

func listRuns(r *request) (*answer, *wire.Problem) {
	page, next, p := r.Registry.Page(r.account, r.values["query:cursor"], r.limit())
	if p != nil {
		return nil, p
	}
	views := []wire.Object{}
	for _, item := range page {
		item.Enter()
		views = append(views, item.View())
		item.Leave()
	}
	return ok(wire.Object{{"runs", views}, {"next_cursor", wire.OrNull(next)}})
}

func (r *request) limit() int {
	if given, err := strconv.Atoi(r.values["query:limit"]); err == nil {
		return given
	}
	return pageSize
}

// run finds the run of the path, locked; the caller leaves it.
func (r *request) run() (*runs.Run, *wire.Problem) {
	found, p := r.Registry.Find(r.account, r.values["path:run_id"])
	if p == nil {
		found.Enter()
	}
	return found, p
}

// getRun waits, if the caller prefers that, until the ETag does not hold any more
// (RUN-011 to RUN-013).
func getRun(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	wait, _ := strconv.Atoi(strings.TrimPrefix(r.values["header:Prefer"], "wait="))
	timeout := time.After(time.Duration(min(wait, waitMax)) * time.Second)
	known := r.values["header:If-None-Match"]
	for {
		etag, view, changed := found.Etag(), found.View(), found.Changes()
		found.Leave()
		if strings.TrimSpace(known) == "*" {
			known = etag // it names the run as it was when the request came
		}
		header := http.Header{"Etag": {etag}}
		if !names(known, etag) {
			return &answer{status: 200, header: header, body: view}, nil
		}
		unchanged := &answer{status: 304, header: header}
		select {
		case <-changed:
		case <-timeout:
			return unchanged, nil
		case <-r.http.Context().Done():
			return unchanged, nil
		}
		found.Enter()
	}
}

var etagPattern = regexp.MustCompile(`^\s*(?:W/)?("[\x21\x23-\x7e\x80-\xff]*")\s*(?:,|$)`)

// names reports whether a list of ETags names this one; a text that is no ETag names none.
func names(tags, etag string) bool {
	for {
		found := etagPattern.FindStringSubmatch(tags)
		if found == nil {
			return false
		}
		if found[1] == etag {
			return true
		}
		tags = tags[len(found[0]):]
	}
}

func stopRun(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	if p := found.Stop(r.body["mode"] == "drain"); p != nil {
		return nil, p
	}
	return ok(found.View())
}

func resumeRun(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	if p := found.Resume(); p != nil {
		return nil, p
	}
	return ok(found.View())
}

// listEpisodes gives a page in manifest order (EPI-006).
func listEpisodes(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	views, next, p := found.Page(r.values["query:cursor"], r.limit())
	if p != nil {
		return nil, p
	}
	return ok(wire.Object{{"episodes", views}, {"next_cursor", wire.OrNull(next)}})
}

func getScore(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	return ok(found.ScoreView()) // SCORE-010
}

func compareRuns(r *request) (*answer, *wire.Problem) {
	ids := append([]string{r.values["query:baseline"]}, strings.Split(r.values["query:runs"], ",")...)
	var chosen []*runs.Run
	for _, id := range ids {
		found, p := r.Registry.Find(r.account, id)
		if p != nil { // CMP-010
			return nil, p
		}
		chosen = append(chosen, found)
	}
	baseline := chosen[0]
	if slices.ContainsFunc(chosen, baseline.Differs) {
		return nil, wire.RefuseAt("not_comparable", "CMP-009", "query:runs", "have different manifests")
	}
	tolerance := 0.05
	if given, err := strconv.ParseFloat(r.values["query:tolerance"], 64); err == nil {
		tolerance = given
	}
	compared := []wire.Object{}
	theirs := gradedOf(baseline)
	for i, ours := range chosen[1:] { // CMP-001
		compared = append(compared, append(wire.Object{{"run_id", ids[i+1]}},
			scoring.Compare(theirs, gradedOf(ours), tolerance)...))
	}
	return ok(wire.Object{
		{"baseline", baseline.ID}, {"benchmark_id", calibration.BenchmarkID},
		{"manifest_sha256", baseline.SHA256}, {"tolerance", tolerance}, {"runs", compared},
	})
}

func gradedOf(r *runs.Run) []scoring.Graded {
	r.Enter()
	defer r.Leave()
	return r.Graded()
}

func attachWorker(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	turn, p := found.Attach(r.values["path:worker_id"], r.body, &calibration.Stopwatch{Begun: r.begun})
	if p != nil {
		return nil, p
	}
	return ok(turn)
}

func predict(r *request) (*answer, *wire.Problem) {
	found, p := r.Registry.Find(r.account, r.values["path:run_id"])
	if p != nil {
		return nil, p
	}
	watch := &calibration.Stopwatch{Begun: r.begun}
	turn, p := found.Predict(r.values["path:worker_id"], r.body, watch)
	if p != nil {
		return nil, p
	}
	return ok(turn)
}

func heartbeat(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	lease, p := found.Heartbeat(r.values["path:worker_id"], r.body["session_id"].(string))
	if p != nil {
		return nil, p
	}
	return ok(lease)
}

func detachWorker(r *request) (*answer, *wire.Problem) {
	found, p := r.run()
	if p != nil {
		return nil, p
	}
	defer found.Leave()
	if p := found.Detach(r.values["path:worker_id"], r.values["query:session_id"]); p != nil {
		return nil, p
	}
	return &answer{status: 204}, nil
}
