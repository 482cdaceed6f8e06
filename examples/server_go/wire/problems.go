// Refusals: the codes of x-problems with their status, `retryable` and `side_effects`, and
// the body that carries them (RFC 9457).
package wire

type problemKind struct {
	Status    int
	retryable bool
	effects   string
	title     string
}

var problemKinds = map[string]problemKind{
	"malformed_body":         {400, false, "none", "The body cannot be parsed"},
	"unsupported_version":    {400, false, "none", "Protocol version not spoken here"},
	"unauthenticated":        {401, false, "none", "No valid bearer token"},
	"forbidden":              {403, false, "none", "The token lacks a scope"},
	"not_found":              {404, false, "none", "There is nothing here for this caller"},
	"method_not_allowed":     {405, false, "none", "Method not allowed"},
	"not_acceptable":         {406, false, "none", "No acceptable encoding"},
	"illegal_transition":     {409, false, "none", "Not possible in this state"},
	"idempotency_conflict":   {409, false, "none", "Idempotency-Key used for another body"},
	"worker_busy":            {409, true, "none", "The worker has a live session"},
	"convention_mismatch":    {409, false, "none", "The policy assumes other conventions"},
	"session_superseded":     {409, false, "none", "Another session has taken this worker over"},
	"session_ended":          {409, false, "none", "The session is not live any more"},
	"seq_conflict":           {409, false, "none", "The same seq with another body"},
	"seq_out_of_order":       {409, false, "none", "Not the seq that is expected"},
	"no_episode":             {409, false, "none", "The session is done"},
	"not_comparable":         {409, false, "none", "The runs have different manifests"},
	"body_too_large":         {413, false, "none", "The body is too large"},
	"unsupported_media_type": {415, false, "none", "The body's media type is not read here"},
	"invalid_request": {422, false, "none",
		"The request breaks the schema or the benchmark's spaces"},
	"worker_limit":   {429, true, "none", "The run has all the live workers it may have"},
	"internal_error": {500, true, "possible", "A defect of the server"},
}

// Fault is one place of a request that is wrong: a JSON pointer, or `query:name`.
type Fault struct {
	pointer string
	detail  string
}

// Problem is a refusal; `rule` is the id of the rule that was enforced.
type Problem struct {
	Code        string
	Rule        string
	Detail      string
	Faults      []Fault
	State       string
	ExpectedSeq int64
	EndedBy     string
	Allow       string // methods
}

func Refuse(code, rule, detail string) *Problem {
	return &Problem{Code: code, Rule: rule, Detail: detail}
}

// RefuseAt refuses with a pointer to the one thing that is wrong.
func RefuseAt(code, rule, pointer, detail string) *Problem {
	return &Problem{Code: code, Rule: rule, Detail: detail, Faults: []Fault{{pointer, detail}}}
}

func (p *Problem) Kind() problemKind { return problemKinds[p.Code] }

func (p *Problem) Body() Object {
	kind := p.Kind()
	made := Object{
		{"type", "about:blank"}, {"title", kind.title}, {"status", kind.Status},
		{"detail", p.Detail}, {"code", p.Code}, {"retryable", kind.retryable},
		{"side_effects", kind.effects},
	}
	if p.Faults != nil {
		items := []Object{}
		for _, f := range p.Faults {
			items = append(items, Object{{"pointer", f.pointer}, {"detail", f.detail}})
		}
		made = append(made, Member{"errors", items})
	}
	if p.Rule != "" {
		made = append(made, Member{"requirement", p.Rule})
	}
	if p.State != "" {
		made = append(made, Member{"state", p.State})
	}
	if p.ExpectedSeq > 0 {
		made = append(made, Member{"expected_seq", p.ExpectedSeq})
	}
	if p.EndedBy != "" {
		made = append(made, Member{"ended_by", p.EndedBy})
	}
	return made
}
