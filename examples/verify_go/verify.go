package main

import (
	"bytes"
	"fmt"
	"os"
	"slices"
)

const (
	statementType = "https://in-toto.io/Statement/v1"
	recordType    = "urn:proctor:robot-evaluation:v1"
	svrType       = "https://in-toto.io/attestation/svr/v0.1"
	lineBytesMax  = 1 << 16
)

// verify gives the levels of a record in which nothing is wrong (REC-031), or *broken.
// keys: keyid → whose key it is; where there are any, the host's must be one of them.
func verify(path string, keys map[string]string) (levels []string, err error) {
	defer func() {
		if found := recover(); found != nil {
			wrong, is := found.(*broken)
			if !is {
				panic(found)
			}
			err = wrong
		}
	}()
	file, err := os.Open(path)
	if err != nil {
		return nil, err
	}
	defer file.Close()
	status, err := file.Stat()
	if err != nil {
		return nil, err
	}
	records := openArchive(file, status.Size())
	data := records.read(statementName)
	keyid, episodes := checkRecord(records, data)
	replays := checkVerdicts(records, hexDigest(data), episodes, keys)
	name, known := keys[keyid]
	if !known && len(keys) > 0 {
		refuse(statementName, "REC-031", "it is signed by %s, which is none of the keys named", keyid)
	}
	if !known {
		return []string{"reported"}, nil
	}
	return append([]string{"signed by " + name}, replays...), nil
}

func checkRecord(records *archive, data []byte) (keyid string, episodes int) {
	statement, keyid := openEnvelope(statementName, data, "host")
	checkTypes(statement, recordType)
	digests := checkFiles(records, statement)
	evaluation := statement.object("predicate")
	sha256 := evaluation.text("manifest_sha256")
	if digests[manifestName] != sha256 {
		refuse(manifestName, "REC-008", "its SHA-256 is not the manifest_sha256 of the run")
	}
	manifest := readObject(manifestName, records.read(manifestName))
	benchmark := evaluation.object("benchmark")
	for _, name := range []string{"benchmark_id", "version"} {
		if manifest.text(name) != benchmark.text(name) {
			refuse(manifestName, "REC-008", "it is of another benchmark")
		}
	}
	lines := checkLines(records, manifest, digests)
	for _, line := range lines {
		if line.has("recording") {
			checkRecording(records, line)
		}
	}
	score := evaluation.object("score")
	if score.text("run_id") != evaluation.object("run").text("run_id") ||
		score.text("benchmark_id") != benchmark.text("benchmark_id") ||
		score.text("manifest_sha256") != sha256 {
		refuse(statementName, "REC-013", "its score is of another run")
	}
	if difference := differ(computeScore(lines), score.members, ""); difference != "" {
		refuse(statementName, "REC-013", "its score does not follow: %s", difference)
	}
	return keyid, len(lines)
}

func checkTypes(statement *object, predicateType string) {
	if statement.text("_type") != statementType || statement.text("predicateType") != predicateType {
		refuse(statement.file, "REC-007", "it is of another type")
	}
}

// checkFiles gives name → SHA-256 of the files that are listed (REC-007, REC-008).
func checkFiles(records *archive, statement *object) map[string]string {
	digests := map[string]string{}
	var listed []string
	for _, subject := range statement.objects("subject") {
		name := subject.text("name")
		if _, twice := digests[name]; twice {
			refuse(statementName, "REC-007", "it lists a file twice")
		}
		listed = append(listed, name)
		digests[name] = subject.object("digest").text("sha256")
	}
	found := records.names()
	for _, name := range listed {
		if !slices.Contains(found, name) {
			refuse(name, "REC-007", "the statement lists this file, and the record has none")
		}
	}
	for _, name := range found {
		if _, has := digests[name]; !has {
			refuse(name, "REC-007", "the statement does not list this file")
		}
	}
	if !slices.Equal(listed, found) {
		refuse(statementName, "REC-007", "it lists the files out of order")
	}
	for _, name := range found {
		if records.digest(name) != digests[name] {
			refuse(name, "REC-008", "its SHA-256 is not that in the statement")
		}
	}
	return digests
}

// checkLines reads episodes.jsonl (REC-004, REC-009, and REC-010 of files).
func checkLines(records *archive, manifest *object, digests map[string]string) []*object {
	planned, ids := manifest.objects("episodes"), map[string]bool{}
	var lines []*object
	data := records.read(episodesName)
	for number := 0; len(data) > 0; number++ {
		text, rest, ended := bytes.Cut(data, []byte("\n"))
		if len(text) > lineBytesMax {
			refuse(episodesName, "REC-030", "line %d is too long", number+1)
		}
		if !ended {
			refuse(episodesName, "REC-004", "line %d has no end", number+1)
		}
		line := readObject(episodesName, text)
		checkOutcome(line, number)
		if line.count("index") != int64(number) || number >= len(planned) ||
			line.text("task") != planned[number].text("task") ||
			line.text("split") != planned[number].text("split") || ids[line.text("episode_id")] {
			refuse(episodesName, "REC-009", "line %d is not of that episode", number+1)
		}
		ids[line.text("episode_id")] = true
		checkLink(line, number, digests)
		lines, data = append(lines, line), rest
	}
	if len(planned) == 0 || len(lines) < len(planned) {
		refuse(episodesName, "REC-009", "an episode of the manifest is missing")
	}
	for _, name := range records.names() {
		if isRecording(name) && name > recordingName(len(lines)-1) {
			refuse(name, "REC-010", "no episode has this recording")
		}
	}
	return lines
}

func recordingName(index int) string { return fmt.Sprintf("episodes/%05d.mcap", index) }

func checkOutcome(line *object, number int) {
	scored := line.has("outcome")
	outcome := ""
	if scored {
		outcome = line.text("outcome")
	}
	wrong := line.flag("success") != (outcome == "success") || scored != line.has("score") ||
		scored && !line.has("recording")
	if wrong || outcome == "abandoned" && line.number("score") != 0 {
		refuse(episodesName, "REC-009", "line %d contradicts itself", number+1)
	}
}

func checkLink(line *object, number int, digests map[string]string) {
	name := recordingName(number)
	sha256, listed := digests[name]
	if !line.has("recording") {
		if listed {
			refuse(name, "REC-010", "episodes.jsonl does not name this file")
		}
		return
	}
	facts := line.object("recording")
	if facts.text("path") != name || !listed || facts.text("sha256") != sha256 {
		refuse(episodesName, "REC-010", "line %d names another recording", number+1)
	}
}

// checkVerdicts gives the replays by those whose keys are known (REC-014).
func checkVerdicts(records *archive, sha256 string, episodes int, keys map[string]string) (replays []string) {
	for _, one := range records.entries {
		if !isVerdict(one.name) {
			continue
		}
		statement, keyid := openEnvelope(one.name, records.read(one.name), "verifier")
		checkTypes(statement, svrType)
		subjects := statement.objects("subject")
		if len(subjects) != 1 || subjects[0].text("name") != statementName ||
			subjects[0].object("digest").text("sha256") != sha256 {
			refuse(one.name, "REC-014", "it is about another record")
		}
		result, count := checkReplay(statement.object("predicate"), episodes)
		if who, known := keys[keyid]; known && result != "diverged" {
			replays = append(replays, fmt.Sprintf("replayed by %s (%s, %d of %d episodes)", who, result, count, episodes))
		}
	}
	return replays
}

func checkReplay(predicate *object, episodes int) (string, int64) {
	replay := predicate.object("replay")
	exact, outcome, diverged := replay.count("exact"), replay.count("outcome"), replay.count("diverged")
	result, properties := "exact", []any{"PROCTOR_REPLAYED_EXACT", "PROCTOR_REPLAYED_OUTCOME"}
	if diverged > 0 {
		result, properties = "diverged", []any{}
	} else if outcome > 0 {
		result, properties = "outcome", []any{"PROCTOR_REPLAYED_OUTCOME"}
	}
	said, _ := predicate.members["properties"].([]any)
	count := replay.count("episodes")
	if exact+outcome+diverged != count || count == 0 || count > int64(episodes) || replay.text("result") != result ||
		!slices.Equal(said, properties) {
		refuse(predicate.file, "REC-014", "what it says contradicts itself")
	}
	return result, count
}
