// The HTTP layer: from a request to an operation and back, in the order that the text
// recommends: path, method, version, token, scope, parameters and headers, Accept, media
// type and size of the body, its syntax, its schema. It knows no rule about runs.
package api

import (
	"crypto/sha256"
	"fmt"
	"io"
	"log"
	"maps"
	"net/http"
	"net/url"
	"runtime/debug"
	"slices"
	"strconv"
	"strings"
	"time"

	"proctor-server-go/runs"
	"proctor-server-go/wire"
)

const (
	mediaJSON    = "application/json"
	mediaMsgpack = "application/msgpack"
	mediaEvents  = "text/event-stream"
	protocol     = "1.0"
)

type account struct {
	name   string
	scopes []string
}

// ReadTokens keeps nothing of a token but its hash (AUTH-006).
func ReadTokens(setting string) (map[[sha256.Size]byte]account, error) {
	tokens := map[[sha256.Size]byte]account{}
	for _, entry := range strings.Split(setting, ",") {
		parts := strings.SplitN(strings.TrimSpace(entry), ":", 3)
		if len(parts) != 3 || parts[2] == "" {
			return nil, fmt.Errorf("PROCTOR_TOKENS must be account:scopes:token, comma-separated")
		}
		tokens[sha256.Sum256([]byte(parts[2]))] = account{parts[0], strings.Split(parts[1], "+")}
	}
	return tokens, nil
}

type Server struct {
	Registry *runs.Registry
	Tokens   map[[sha256.Size]byte]account // AUTH-006: by hash
}

// request is what an operation gets: everything of it has been checked against its schema.
type request struct {
	*Server
	http    *http.Request
	begun   time.Time
	account string
	values  map[string]string // parameters by `path:name`, `query:name`, `header:name`
	body    map[string]any
}

// answer has a body in the media type, or is a stream, or has neither.
type answer struct {
	status    int
	header    http.Header
	mediaType string
	body      wire.Object
	stream    func(io.Writer, func())
}

func ok(body wire.Object) (*answer, *wire.Problem) {
	return &answer{status: 200, header: http.Header{}, body: body}, nil
}

func answerTo(p *wire.Problem) *answer {
	status, header := p.Kind().Status, http.Header{}
	if status == 401 {
		header.Set("WWW-Authenticate", `Bearer realm="proctor"`) // AUTH-002
	}
	if status == 405 {
		header.Set("Allow", p.Allow) // ERR-022
	}
	if status == 429 {
		header.Set("Retry-After", "1") // ERR-011
	}
	return &answer{status, header, "application/problem+json", p.Body(), nil}
}

type operation struct {
	public     bool // without a token
	parameters []parameter
	produces   []string // media types of its successful answers
	consumes   []string
	body       wire.Shape
	handle     func(*request) (*answer, *wire.Problem)
}

func (s *Server) ServeHTTP(w http.ResponseWriter, r *http.Request) {
	begun := time.Now()
	w.Header().Set("Proctor-Version", protocol) // VER-001
	defer func() {
		if broken := recover(); broken != nil {
			log.Printf("%s %s: %v\n%s", r.Method, r.URL.Path, broken, debug.Stack())
			write(w, answerTo(wire.Refuse("internal_error", "", "See the server's log.")))
		}
	}()
	made, p := s.serve(r, begun)
	if p != nil {
		made = answerTo(p)
	}
	write(w, made)
}

func (s *Server) serve(r *http.Request, begun time.Time) (*answer, *wire.Problem) {
	methods, values := route(r.URL.EscapedPath())
	if methods == nil { // ERR-009
		return nil, wire.Refuse("not_found", "ERR-009", "This path is not part of the protocol.")
	}
	op, known := methods[r.Method]
	if !known {
		return nil, &wire.Problem{Code: "method_not_allowed", Rule: "ERR-010",
			Detail: "Use a method named in Allow.",
			Allow:  strings.Join(slices.Sorted(maps.Keys(methods)), ", ")}
	}
	if p := checkVersion(r.Header); p != nil {
		return nil, p
	}
	req := &request{Server: s, http: r, begun: begun, values: values}
	if !op.public {
		caller, p := s.authenticate(r)
		if p != nil {
			return nil, p
		}
		req.account = caller
	}
	if p := readParameters(op.parameters, r, values); p != nil {
		return nil, p
	}
	mediaType, p := negotiate(r.Header.Values("Accept"), op.produces)
	if p != nil {
		return nil, p
	}
	if op.consumes != nil {
		if req.body, p = readBody(r, op); p != nil {
			return nil, p
		}
	}
	made, p := op.handle(req)
	if p == nil && made.mediaType == "" {
		made.mediaType = mediaType
	}
	return made, p
}

func write(w http.ResponseWriter, made *answer) {
	for name, values := range made.header {
		w.Header()[name] = values
	}
	if made.stream != nil {
		w.Header().Set("Content-Type", made.mediaType)
		w.Header().Set("Cache-Control", "no-store")
		w.Header().Set("X-Accel-Buffering", "no") // or nginx keeps it until it ends
		w.WriteHeader(made.status)
		made.stream(w, w.(http.Flusher).Flush)
		return
	}
	if made.body == nil {
		w.WriteHeader(made.status)
		return
	}
	text := appendFor(made.mediaType, made.body)
	w.Header().Set("Content-Type", made.mediaType)
	w.Header().Set("Content-Length", strconv.Itoa(len(text)))
	w.WriteHeader(made.status)
	_, _ = w.Write(text) // a client that has gone repeats its request
}

func appendFor(mediaType string, body wire.Object) []byte {
	if mediaType == mediaMsgpack {
		return wire.AppendMsgpack(nil, body)
	}
	return wire.AppendJSON(nil, body)
}

// checkVersion refuses what is not spoken here (VER-002).
func checkVersion(header http.Header) *wire.Problem {
	asked, given := header["Proctor-Version"]
	if !given {
		return nil
	}
	joined := strings.Join(asked, ", ")
	if !versionPattern.MatchString(joined) { // ERR-014
		return wire.RefuseAt("invalid_request", "ERR-014", "header:Proctor-Version",
			"must be MAJOR.MINOR")
	}
	major, minor, _ := strings.Cut(joined, ".")
	if strings.TrimLeft(major, "0") != "1" || strings.Trim(minor, "0") != "" {
		return wire.Refuse("unsupported_version", "VER-002", "This server speaks version 1.0.")
	}
	return nil
}

// authenticate finds the account of the token and asks for the scope: `read` for every GET,
// `run` for everything else (AUTH-001, AUTH-005).
func (s *Server) authenticate(r *http.Request) (string, *wire.Problem) {
	scheme, token, _ := strings.Cut(r.Header.Get("Authorization"), " ")
	caller, known := s.Tokens[sha256.Sum256([]byte(strings.TrimSpace(token)))]
	if !strings.EqualFold(scheme, "Bearer") || !known {
		return "", wire.Refuse("unauthenticated", "AUTH-001", "Send a bearer token of this server.")
	}
	scope := "run"
	if r.Method == http.MethodGet {
		scope = "read"
	}
	if !slices.Contains(caller.scopes, scope) {
		return "", wire.Refuse("forbidden", "AUTH-005", "The token lacks the scope "+scope+".")
	}
	return caller.name, nil
}

// negotiate chooses the first of the best accepted media types, so that JSON comes before
// MessagePack (ENC-001).
func negotiate(accepted, produced []string) (string, *wire.Problem) {
	ranges := strings.Join(accepted, ",")
	if strings.TrimSpace(ranges) == "" || len(produced) == 0 {
		return append(produced, "")[0], nil
	}
	best, chosen := 0.0, ""
	for _, mediaType := range produced {
		if quality := qualityOf(ranges, mediaType); quality > best {
			best, chosen = quality, mediaType
		}
	}
	if chosen == "" { // ERR-008
		return "", wire.Refuse("not_acceptable", "ERR-008", "Accept "+strings.Join(produced, " or ")+".")
	}
	return chosen, nil
}

// qualityOf is that of the most specific range that fits.
func qualityOf(ranges, mediaType string) float64 {
	kind, _, _ := strings.Cut(mediaType, "/")
	fits := []string{"*/*", kind + "/*", mediaType}
	quality, closest := 0.0, -1
	for _, entry := range strings.Split(ranges, ",") {
		parts := strings.Split(entry, ";")
		place := slices.Index(fits, strings.ToLower(strings.TrimSpace(parts[0])))
		if place <= closest {
			continue
		}
		closest, quality = place, 1
		for _, parameter := range parts[1:] {
			name, value, _ := strings.Cut(strings.TrimSpace(parameter), "=")
			if strings.EqualFold(name, "q") {
				quality, _ = strconv.ParseFloat(value, 64)
			}
		}
	}
	return quality
}

// readBody reads, parses and checks a body (ERR-002 to ERR-007).
func readBody(r *http.Request, op operation) (map[string]any, *wire.Problem) {
	mediaType, _, _ := strings.Cut(r.Header.Get("Content-Type"), ";")
	mediaType = strings.ToLower(strings.TrimSpace(mediaType))
	if !slices.Contains(op.consumes, mediaType) { // ERR-007
		return nil, wire.Refuse("unsupported_media_type", "ERR-007",
			"Send "+strings.Join(op.consumes, " or ")+".")
	}
	text, err := io.ReadAll(io.LimitReader(r.Body, maxBodyBytes+1))
	if err != nil {
		return nil, wire.Refuse("malformed_body", "ERR-002", "The body did not arrive whole.")
	}
	if len(text) > maxBodyBytes { // ERR-005
		// Read on for a while: a client that is still sending could miss the answer.
		_, _ = io.Copy(io.Discard, io.LimitReader(r.Body, 4*maxBodyBytes))
		return nil, wire.Refuse("body_too_large", "ERR-005",
			fmt.Sprintf("Send at most %d bytes.", maxBodyBytes))
	}
	parse := wire.ParseJSON
	if mediaType == mediaMsgpack {
		parse = wire.ParseMsgpack
	}
	value, err := parse(text)
	if err != nil {
		return nil, wire.Refuse("malformed_body", "ERR-002", "The body is "+err.Error()+".")
	}
	found := &wire.Findings{}
	op.body("", value, found)
	if found.Faults != nil {
		return nil, &wire.Problem{Code: "invalid_request", Rule: "ERR-004", Faults: found.Faults,
			Detail: "The body breaks the schema of the operation."}
	}
	return value.(map[string]any), nil
}

// queryValues reads a query without refusing any: a value that is not well-formed stays as
// it is and breaks its schema.
func queryValues(query string) map[string][]string {
	values := map[string][]string{}
	for _, pair := range strings.Split(query, "&") {
		name, value, _ := strings.Cut(pair, "=")
		if decoded, err := url.QueryUnescape(value); err == nil {
			value = decoded
		}
		if decoded, err := url.QueryUnescape(name); err == nil {
			name = decoded
		}
		values[name] = append(values[name], value)
	}
	return values
}
