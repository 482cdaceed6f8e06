// The benchmark `calibration` of spec/calibration.md: its manifest and spaces, and the
// simulator, which is a counter. It knows nothing of runs, sessions or HTTP.
package calibration

import (
	"crypto/sha256"
	"encoding/hex"
	"encoding/json"
	"fmt"
	"math"
	"slices"
	"strconv"
	"time"

	"proctor-server-go/wire"
)

const (
	BenchmarkID      = "calibration"
	BenchmarkVersion = "1"
	ControlRate      = 10.0
	FirstSeed        = 1000

	MaxChunk = 64 // as in the limits of the server
)

var (
	TaskNames  = []string{"score", "count", "echo", "delay", "fault"}
	splitNames = []string{"even", "odd"}
	imageSizes = [][2]int{{16, 12}, {64, 48}}
	CodecNames = []string{"raw", "png", "jpeg"}
)

// VectorSpace is an entry of the action or of the state space, with one part, PartName.
// A policy may assume its conventions; lowest and highest hold for every element.
type VectorSpace struct {
	Name            string
	size            int
	unit            string
	outOfRange      string
	lowest, highest float64
	description     string
}

var ActionSpace = []VectorSpace{
	{"score", 1, "1", "refuse", 0, 1, "Score of the episode so far in the task score."},
	{"success", 1, "1", "refuse", 0, 1, "1: the goal condition holds after this step."},
	{"end", 1, "1", "refuse", 0, 1, "1: the episode terminates after this step."},
	{"delay_s", 1, "s", "refuse", 0, 5, "Duration of this step in the task delay."},
	{"fault", 1, "1", "refuse", 0, 2, "Task fault: 1 kills the simulator, 2 is unplayable."},
	{"vector", 8, "1", "unbounded", 0, 0, "Comes back in the state vector."},
	{"clipped", 2, "1", "clip", -1, 1, "Comes back in the state clipped, clipped."},
}

var StateSpace = []VectorSpace{
	{"count", 1, "1", "unbounded", 0, 0, "Actions executed in this attempt."},
	{"vector", 8, "1", "unbounded", 0, 0, "vector of the last executed action."},
	{"clipped", 2, "1", "unbounded", 0, 0, "clipped of the last executed action, clipped."},
}

const PartName = "all"

// Assumable gives the value of a member of the part that a policy may assume; nil where it
// has none, which contradicts any assumption (ATT-010).
func (s VectorSpace) Assumable(name string) any {
	return map[string]any{
		"start": 0.0, "size": float64(s.size), "quantity": s.quantity(), "unit": s.unit,
		"scale": 1.0, "frame": "none", "rotation": "none", "relative_to": "none",
	}[name]
}

func (s VectorSpace) quantity() string {
	if s.unit == "s" {
		return "time"
	}
	return "number"
}

func (s VectorSpace) object() wire.Object {
	part := wire.Object{
		{"start", 0}, {"size", s.size}, {"quantity", s.quantity()}, {"unit", s.unit},
		{"frame", "none"}, {"rotation", "none"}, {"relative_to", "none"},
	}
	made := wire.Object{
		{"size", s.size}, {"parts", wire.Object{{PartName, part}}},
		{"out_of_range", s.outOfRange}, {"description", s.description},
	}
	if s.outOfRange != "unbounded" {
		made = append(made, wire.Member{"minimum", repeat(s.lowest, s.size)})
		made = append(made, wire.Member{"maximum", repeat(s.highest, s.size)})
	}
	return made
}

func repeat(value float64, count int) []float64 {
	return slices.Repeat([]float64{value}, count)
}

func spacesObject(spaces []VectorSpace) wire.Object {
	made := wire.Object{}
	for _, space := range spaces {
		made = append(made, wire.Member{space.Name, space.object()})
	}
	return made
}

// tensor is one of the constant tensors of the task `echo`, little-endian in C order.
type tensor struct {
	name, dtype string
	shape       []int
	data        []byte
}

// integers packs -2, -1, 0, 1, smallest, largest or, unsigned, 0 … 4, largest.
func integers(dtype string, bytes int, signed bool) tensor {
	largest := uint64(math.MaxUint64) >> (64 - 8*bytes)
	elements := []uint64{0, 1, 2, 3, 4, largest}
	if signed {
		minusTwo := uint64(math.MaxUint64 - 1)
		elements = []uint64{minusTwo, minusTwo + 1, 0, 1, largest/2 + 1, largest / 2}
	}
	return pack(dtype, bytes, elements)
}

func pack(dtype string, bytes int, elements []uint64) tensor {
	var data []byte
	for _, element := range elements {
		for i := range bytes {
			data = append(data, byte(element>>(8*i)))
		}
	}
	return tensor{dtype, dtype, []int{2, 3}, data}
}

// The elements of floats are -2, -0.5, 0, 0.5, smallest normal, largest finite, as bits.
var tensors = []tensor{
	pack("bool", 1, []uint64{0, 1, 0, 1, 0, 1}),
	integers("int8", 1, true), integers("int16", 2, true),
	integers("int32", 4, true), integers("int64", 8, true),
	integers("uint8", 1, false), integers("uint16", 2, false),
	integers("uint32", 4, false), integers("uint64", 8, false),
	pack("float16", 2, []uint64{0xc000, 0xb800, 0, 0x3800, 0x0400, 0x7bff}),
	pack("float32", 4, []uint64{0xc0000000, 0xbf000000, 0, 0x3f000000, 0x800000, 0x7f7fffff}),
	pack("float64", 8, []uint64{0xc000000000000000, 0xbfe0000000000000, 0, 0x3fe0000000000000,
		0x0010000000000000, 0x7fefffffffffffff}),
	{"empty", "float64", []int{0, 3}, []byte{}},
}

func observationSpace() wire.Object {
	onlyEcho := wire.Member{"tasks", []string{"echo"}}
	tensorSpaces := wire.Object{}
	for _, t := range tensors {
		tensorSpaces = append(tensorSpaces, wire.Member{t.name, wire.Object{
			{"dtype", t.dtype}, {"shape", t.shape}, {"description", "Constant."}, onlyEcho,
		}})
	}
	return wire.Object{
		{"state", spacesObject(StateSpace)},
		{"images", wire.Object{{"pattern", wire.Object{
			{"channels", 3}, {"description", "(7x + 13y + 29c + count) mod 256."}, onlyEcho,
		}}}},
		{"tensors", tensorSpaces},
	}
}

// Manifest is all of a benchmark that can change a score.
type Manifest struct {
	Tasks       []string
	MaxSteps    int
	SuccessRule string
	MaxAttempts int
	MaxFaults   int
}

func Split(index int) string { return splitNames[index%2] }

// ManifestOf applies the options of a submit; nil stands for none.
func ManifestOf(options map[string]any) Manifest {
	made := Manifest{[]string{"score"}, 10, "any_step", 3, 3}
	if tasks, given := options["tasks"].([]any); given {
		made.Tasks = nil
		for _, task := range tasks {
			made.Tasks = append(made.Tasks, task.(string))
		}
	}
	set := func(name string, target *int) {
		if value, given := options[name].(float64); given {
			*target = int(value)
		}
	}
	set("max_steps", &made.MaxSteps)
	set("max_attempts", &made.MaxAttempts)
	set("max_faults", &made.MaxFaults)
	if rule, given := options["success_rule"].(string); given {
		made.SuccessRule = rule
	}
	return made
}

func (m Manifest) Rules() wire.Object {
	sizes := []wire.Object{}
	for _, size := range imageSizes {
		sizes = append(sizes, wire.Object{{"width", size[0]}, {"height", size[1]}})
	}
	return wire.Object{
		{"benchmark_id", BenchmarkID}, {"version", BenchmarkVersion},
		{"tasks", TaskNames}, {"splits", splitNames}, {"control_rate_hz", ControlRate},
		{"max_steps", m.MaxSteps}, {"max_chunk", MaxChunk}, {"max_attempts", m.MaxAttempts},
		{"max_faults", m.MaxFaults}, {"success_rule", m.SuccessRule},
		{"action_space", spacesObject(ActionSpace)}, {"observation_space", observationSpace()},
		{"image_sizes", sizes}, {"image_codecs", CodecNames},
		{"simulator", wire.Object{{"name", BenchmarkID}, {"version", "1"}}},
	}
}

// notInManifest explains the benchmark or is the server's choice: no score depends on it.
var notInManifest = []string{"max_chunk", "image_sizes", "image_codecs"}

// Digest is `manifest_sha256`: that of the canonical manifest (BEN-003, BEN-006).
func (m Manifest) Digest() string {
	episodes := []any{}
	for i, task := range m.Tasks {
		episodes = append(episodes, map[string]any{
			"task": task, "split": Split(i), "seed": FirstSeed + i,
		})
	}
	manifest := unexplained(m.Rules()).(map[string]any)
	manifest["episodes"] = episodes
	for _, name := range notInManifest {
		delete(manifest, name)
	}
	// json sorts names by bytes and writes numbers as RFC 8785 does, and texts, too, that
	// are ASCII without <, > and &: all of this manifest.
	text, err := json.Marshal(manifest)
	if err != nil {
		panic(err)
	}
	sum := sha256.Sum256(text)
	return hex.EncodeToString(sum[:])
}

// unexplained makes maps of objects, without descriptions.
func unexplained(value any) any {
	object, is := value.(wire.Object)
	if !is {
		return value
	}
	made := map[string]any{}
	for _, m := range object {
		if _, isText := m.Value.(string); !isText || m.Name != "description" {
			made[m.Name] = unexplained(m.Value)
		}
	}
	return made
}

// Action is one validated action; clipped is inside its range already.
type Action struct {
	Score, success, end, delay, fault float64
	vector, clipped                   []float64
}

// ReadAction checks the values of an action against the action space and reports faults
// below the pointer (PRED-013, PRED-014, PRED-017).
func ReadAction(pointer string, values map[string]any, found *wire.Findings) Action {
	vectors := map[string][]float64{}
	for _, space := range ActionSpace {
		vectors[space.Name] = repeat(0, space.size)
		at := wire.PointTo(pointer, space.Name)
		items, there := values[space.Name].([]any)
		if !there || len(items) != space.size {
			found.Add(at, fmt.Sprintf("must be there with %d numbers", space.size))
			continue
		}
		for i, item := range items {
			value := item.(float64)
			switch inside := min(max(value, space.lowest), space.highest); {
			case space.outOfRange == "clip":
				value = inside // PRED-018
			case space.outOfRange == "refuse" && value != inside:
				found.Add(at+"/"+strconv.Itoa(i), fmt.Sprintf(
					"must be between %v and %v", space.lowest, space.highest))
			}
			vectors[space.Name][i] = value
		}
	}
	for _, name := range wire.SortedKeys(values) {
		if _, known := vectors[name]; !known {
			found.Add(wire.PointTo(pointer, name), "is no entry of the action space")
		}
	}
	return Action{
		vectors["score"][0], vectors["success"][0], vectors["end"][0], vectors["delay_s"][0],
		vectors["fault"][0], vectors["vector"], vectors["clipped"],
	}
}

// Simulator plays one attempt of one episode. Its value can be copied: what a step replaces
// is never changed in place.
type Simulator struct {
	task            string
	Count           int
	vector, clipped []float64
	lastScore       float64
	goalEver        bool
	goalNow         bool
	Ended           bool
}

func NewSimulator(task string) Simulator {
	return Simulator{task: task, vector: repeat(0, 8), clipped: repeat(0, 2)}
}

// What a step can come to besides being executed.
const (
	StepExecuted   = "executed"
	StepBroken     = "the simulator was killed by the action"
	StepUnplayable = "the task was reported unplayable"
	stepCancelled  = "the session ended"
)

// Step executes one action and waits as long as it takes, unless cancelled is closed.
func (s *Simulator) Step(a Action, cancelled <-chan struct{}) string {
	if s.task == "fault" && a.fault >= 2 {
		return StepUnplayable
	}
	if s.task == "fault" && a.fault >= 1 {
		return StepBroken
	}
	if s.task == "delay" && a.delay > 0 { // CAL-004
		select {
		case <-time.After(time.Duration(math.Ceil(a.delay * float64(time.Second)))):
		case <-cancelled:
			return stepCancelled
		}
	}
	s.Count++ // CAL-003
	s.vector, s.clipped, s.lastScore = a.vector, a.clipped, a.Score
	s.goalNow = a.success >= 1
	s.goalEver = s.goalEver || s.goalNow
	s.Ended = a.end >= 1 // CAL-005
	return StepExecuted
}

// Success and score are what the attempt comes to if it ends now.
func (s *Simulator) Success(rule string) bool {
	if rule == "last_step" {
		return s.goalNow // SCORE-003
	}
	return s.goalEver // SCORE-002
}

func (s *Simulator) Score(rule string) float64 {
	switch {
	case s.task == "score":
		return s.lastScore // CAL-002
	case s.Success(rule):
		return 1
	}
	return 0
}
