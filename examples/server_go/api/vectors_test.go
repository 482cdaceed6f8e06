// The golden vectors of spec/vectors: what any implementation must make of them.
package api

import (
	"bytes"
	"encoding/base64"
	"encoding/json"
	"math"
	"os"
	"path/filepath"
	"testing"

	"proctor-server-go/calibration"
	"proctor-server-go/scoring"
	"proctor-server-go/wire"
)

const vectorFolder = "../../../spec/vectors/"

func readVector(t *testing.T, path string, into any) {
	t.Helper()
	text, err := os.ReadFile(path)
	if err == nil {
		err = json.Unmarshal(text, into)
	}
	if err != nil {
		t.Fatal(path, err)
	}
}

func vectorPaths(t *testing.T, pattern string) []string {
	t.Helper()
	paths, err := filepath.Glob(vectorFolder + pattern)
	if err != nil || len(paths) == 0 {
		t.Fatal("no vectors ", pattern)
	}
	return paths
}

// vectorEpisode has null for what is not scored, which reads as empty.
type vectorEpisode struct {
	Task, Split, Outcome string
	Score                float64
}

func gradedVector(episodes []vectorEpisode) []scoring.Graded {
	made := []scoring.Graded{}
	for _, e := range episodes {
		made = append(made, scoring.Graded{
			Task: e.Task, Split: e.Split, Outcome: e.Outcome, Score: e.Score,
		})
	}
	return made
}

// expectNear compares two parsed values, numbers with the error that the rules allow.
func expectNear(t *testing.T, where string, made, wanted any) {
	t.Helper()
	switch w := wanted.(type) {
	case float64:
		if m, isNumber := made.(float64); !isNumber || math.Abs(m-w) > 1e-12 {
			t.Errorf("%s: %v, not %v", where, made, w)
		}
	case map[string]any:
		m, _ := made.(map[string]any)
		for name, value := range w {
			expectNear(t, where+"/"+name, m[name], value)
		}
		if len(m) != len(w) {
			t.Errorf("%s: members %v", where, m)
		}
	default:
		if made != wanted {
			t.Errorf("%s: %v, not %v", where, made, wanted)
		}
	}
}

func parsedAgain(t *testing.T, made wire.Object) any {
	t.Helper()
	value, err := wire.ParseJSON(wire.AppendJSON(nil, made))
	if err != nil {
		t.Fatal(err)
	}
	return value
}

func TestScores(t *testing.T) {
	for _, path := range vectorPaths(t, "scoring/*.json") {
		var vector struct {
			Episodes []vectorEpisode
			Score    any
		}
		readVector(t, path, &vector)
		made := scoring.ScoreOf(gradedVector(vector.Episodes))
		expectNear(t, path, parsedAgain(t, made), vector.Score)
	}
}

func TestComparisons(t *testing.T) {
	for _, path := range vectorPaths(t, "comparison/*.json") {
		var vector struct {
			Tolerance     float64
			Baseline, Run []vectorEpisode
			Comparison    any
		}
		readVector(t, path, &vector)
		made := scoring.Compare(gradedVector(vector.Baseline), gradedVector(vector.Run), vector.Tolerance)
		expectNear(t, path, parsedAgain(t, made), vector.Comparison)
	}
}

type wireVector struct {
	ID, Schema, JSON, Msgpack string
	Refused                   bool
}

func wireVectors(t *testing.T, name string) []wireVector {
	t.Helper()
	var file struct{ Vectors []wireVector }
	readVector(t, vectorFolder+"wire/"+name+".json", &file)
	return file.Vectors
}

// TestRequests reads the same from both encodings and refuses what no server executes.
func TestRequests(t *testing.T) {
	for _, vector := range wireVectors(t, "requests") {
		packed, _ := base64.StdEncoding.DecodeString(vector.Msgpack)
		fromPacked, packedErr := wire.ParseMsgpack(packed)
		fromText, textErr := wire.ParseJSON([]byte(vector.JSON))
		if !vector.Refused {
			if packedErr != nil || textErr != nil || wire.Digest(fromPacked) != wire.Digest(fromText) {
				t.Error(vector.ID, packedErr, textErr)
			}
			continue
		}
		for _, read := range []struct {
			value any
			err   error
		}{{fromPacked, packedErr}, {fromText, textErr}} {
			found := &wire.Findings{}
			if read.err == nil {
				predictShape("", read.value, found)
			}
			if read.err == nil && found.Faults == nil {
				t.Error(vector.ID, "is not refused")
			}
		}
	}
}

// TestTensors compares the constants of calibration.md with the vectors of their names.
func TestTensors(t *testing.T) {
	wanted := map[string][]byte{}
	for _, vector := range wireVectors(t, "tensors") {
		var tensor struct{ Data []byte }
		if err := json.Unmarshal([]byte(vector.JSON), &tensor); err != nil {
			t.Fatal(err)
		}
		wanted[vector.ID] = tensor.Data
	}
	echo := calibration.NewSimulator("echo")
	seen := calibration.Observe(&echo, calibration.DefaultImages, &calibration.Stopwatch{})
	arrays := seen[2].Value.(wire.Object)
	if len(arrays) != 13 {
		t.Error("tensors:", len(arrays))
	}
	for _, made := range arrays {
		data, _ := made.Value.(wire.Object)[2].Value.([]byte)
		if wanted := wanted["tensor_"+made.Name]; !bytes.Equal(data, wanted) {
			t.Error(made.Name, data, wanted)
		}
	}
}

// TestWriters gives the bytes of MessagePack vectors back through parse and write.
func TestWriters(t *testing.T) {
	for _, name := range []string{"tensors", "images", "problems", "turns"} {
		for _, vector := range wireVectors(t, name) {
			packed, err := base64.StdEncoding.DecodeString(vector.Msgpack)
			if err != nil {
				t.Fatal(err)
			}
			value, err := wire.ParseMsgpack(packed)
			if err != nil {
				t.Fatal(vector.ID, err)
			}
			again, err := wire.ParseMsgpack(wire.AppendMsgpack(nil, wire.Plain(value)))
			if err != nil || wire.Digest(value) != wire.Digest(again) {
				t.Error(vector.ID, err)
			}
		}
	}
}
