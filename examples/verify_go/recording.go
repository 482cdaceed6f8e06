package main

import "math"

const messageBytesMax = 1 << 24

// played is what the messages of a recording came to.
type played struct {
	name          string
	attempt       int64
	steps         int64
	turns         int
	turn          *object
	result        *object
	first, last   string
	hasFirst, any bool
}

// checkRecording compares a recording with its line (REC-010, REC-011, REC-012).
func checkRecording(records *archive, line *object) {
	facts := line.object("recording")
	name := facts.text("path")
	if records.byName[name].size != facts.count("bytes") {
		refuse(name, "REC-010", "its size is not that in episodes.jsonl")
	}
	story := &played{name: name}
	readMessages(name, records.open(name), func(topic string, data []byte) {
		if len(data) > messageBytesMax {
			refuse(name, "REC-030", "a message has more than %d bytes", messageBytesMax)
		}
		story.add(topic, data)
	})
	if facts.text("first_digest") != story.first || facts.text("last_digest") != story.last {
		refuse(name, "REC-010", "its state digests are not those of episodes.jsonl")
	}
	story.compare(line)
}

// message reads what is of another rule than other JSON: what is wrong is the recording.
func (p *played) message(data []byte) *object {
	defer func() {
		if found := recover(); found != nil {
			refuse(p.name, "REC-012", "a message cannot be read: %v", found)
		}
	}()
	return readObject(p.name, data)
}

func (p *played) add(topic string, data []byte) {
	if p.result != nil {
		refuse(p.name, "REC-012", "a message stands behind its result")
	}
	switch topic {
	case "/attempt":
		if event := p.message(data); event.text("event") == "started" {
			p.begin(event)
		}
	case "/turn":
		turn := p.message(data)
		if turn.count("attempt") != p.attempt {
			refuse(p.name, "REC-012", "a turn belongs to no attempt that began")
		}
		steps := turn.count("steps")
		if turn.length("actions") != steps || turn.length("rewards") != steps {
			refuse(p.name, "REC-012", "a turn has other steps than actions, rewards")
		}
		p.turns++
		p.steps += steps
		p.turn, p.last = turn, turn.text("state_digest")
	case "/result":
		p.result = p.message(data)
	}
}

func (p *played) begin(event *object) {
	attempt := event.count("attempt")
	if attempt < max(p.attempt, 1) {
		refuse(p.name, "REC-012", "attempt %d begins behind %d", attempt, p.attempt)
	}
	p.attempt, p.steps, p.turn = attempt, 0, nil
	digest := event.text("state_digest")
	if p.first == "" {
		p.first = digest
	}
	if p.turns == 0 {
		p.last = digest
	}
}

func (p *played) compare(line *object) {
	if !line.has("outcome") {
		if p.result != nil {
			refuse(p.name, "REC-010", "it has a result, episodes.jsonl has none")
		}
		return
	}
	result := p.result
	if result == nil {
		refuse(p.name, "REC-010", "it has no result, episodes.jsonl has one")
	}
	outcome := result.text("outcome")
	if outcome != line.text("outcome") || result.flag("success") != line.flag("success") ||
		result.number("score") != line.number("score") ||
		result.count("steps") != line.count("steps") ||
		result.count("attempts") != line.count("attempts") {
		refuse(p.name, "REC-010", "its result is not that of episodes.jsonl")
	}
	if outcome == "abandoned" {
		return
	}
	if p.turn == nil || result.count("steps") != p.steps || result.count("attempts") != p.attempt {
		refuse(p.name, "REC-011", "its result is not that of its last attempt")
	}
	if p.turn.flag("success") != result.flag("success") ||
		math.Abs(p.turn.number("score")-result.number("score")) > tolerance {
		refuse(p.name, "REC-011", "its score does not follow from its turns")
	}
	if !p.turn.flag("ended") {
		refuse(p.name, "REC-011", "its last turn did not end the episode")
	}
}
