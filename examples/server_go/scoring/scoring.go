// Scores of spec/scoring.md: episodes in, numbers out. Pure; it knows no run.
package scoring

import (
	"math"

	"proctor-server-go/wire"
)

// Graded is what scoring needs of an episode; outcome is empty while it is unscored.
type Graded struct {
	Task, Split, Outcome string
	Score                float64
}

// tally counts the outcomes of some episodes and adds their scores up.
type tally struct {
	total, success, failure, abandoned int
	scores                             []float64
}

func (t *tally) add(g Graded) {
	t.total++
	switch g.Outcome {
	case "success":
		t.success++
	case "failure":
		t.failure++
	case "abandoned":
		t.abandoned++ // SCORE-004
	default:
		return
	}
	t.scores = append(t.scores, g.Score)
}

// counts is SCORE-008.
func (t *tally) counts() wire.Object {
	return wire.Object{
		{"total", t.total}, {"success", t.success}, {"failure", t.failure},
		{"abandoned", t.abandoned}, {"unscored", t.total - len(t.scores)},
	}
}

// mean and rate are SCORE-009: null without a scored episode.
func (t *tally) mean() any { return meanOf(t.scores) }

func (t *tally) rate() any {
	if len(t.scores) == 0 {
		return nil
	}
	return float64(t.success) / float64(len(t.scores))
}

func (t *tally) group() wire.Object {
	return wire.Object{{"counts", t.counts()}, {"mean", t.mean()}, {"success_rate", t.rate()}}
}

func meanOf(values []float64) any {
	if len(values) == 0 {
		return nil
	}
	return sum(values) / float64(len(values))
}

// sum is that of Neumaier: as if the values were added in twice the precision.
func sum(values []float64) float64 {
	total, lost := 0.0, 0.0
	for _, value := range values {
		next := total + value
		if math.Abs(total) >= math.Abs(value) {
			lost += (total - next) + value
		} else {
			lost += (value - next) + total
		}
		total = next
	}
	return total + lost
}

// grouped keeps the order in which names first come.
type grouped struct {
	names   []string
	tallies map[string]*tally
}

func (g *grouped) add(name string, episode Graded) {
	if g.tallies[name] == nil {
		if g.tallies == nil {
			g.tallies = map[string]*tally{}
		}
		g.names = append(g.names, name)
		g.tallies[name] = &tally{}
	}
	g.tallies[name].add(episode)
}

func (g *grouped) object() wire.Object {
	made := wire.Object{}
	for _, name := range g.names {
		made = append(made, wire.Member{name, g.tallies[name].group()})
	}
	return made
}

// ScoreOf gives the members of schema Score that follow from the episodes.
func ScoreOf(episodes []Graded) wire.Object {
	var all tally
	var byTask, bySplit grouped // SCORE-011
	for _, episode := range episodes {
		all.add(episode)
		byTask.add(episode.Task, episode)
		bySplit.add(episode.Split, episode)
	}
	total, scored, points := float64(all.total), len(all.scores), sum(all.scores)
	complete := scored == all.total // SCORE-005
	var score any
	if complete {
		score = points / total // SCORE-006
	}
	return wire.Object{
		{"complete", complete}, {"score", score},
		{"score_low", points / total}, // SCORE-007
		{"score_high", (points + float64(all.total-scored)) / total},
		{"counts", all.counts()},
		{"success_rate", all.rate()}, {"success_interval", wilson(all.rate(), scored)}, // SCORE-012
		{"mean", all.mean()}, {"mean_interval", wilson(all.mean(), scored)}, // SCORE-013
		{"by_task", byTask.object()}, {"by_split", bySplit.object()},
	}
}

// wilson is the 95 % interval of a rate over n trials; null gives [0, 1].
func wilson(rate any, trials int) wire.Object {
	const z = 1.959963984540054
	low, high := 0.0, 1.0
	if p, known := rate.(float64); known {
		n := float64(trials)
		centre := (p + z*z/(2*n)) / (1 + z*z/n)
		half := z / (1 + z*z/n) * math.Sqrt(p*(1-p)/n+z*z/(4*n*n))
		low, high = max(0, centre-half), min(1, centre+half)
	}
	return wire.Object{{"low", low}, {"high", high}}
}
