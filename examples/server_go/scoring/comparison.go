// Runs beside a baseline (profile `compare`, spec/scoring.md): episodes of two runs in,
// their comparison out. Pure; it knows no run.
package scoring

import (
	"math"
	"math/big"

	"proctor-server-go/wire"
)

// paired holds the scores of the episodes that both runs have scored.
type paired struct {
	baseline, run []float64
}

func (p *paired) means() wire.Object {
	made := wire.Object{
		{"paired", len(p.run)}, {"baseline_mean", meanOf(p.baseline)}, {"mean", meanOf(p.run)},
	}
	if len(p.run) == 0 {
		return append(made, wire.Member{"difference", nil})
	}
	return append(made, wire.Member{"difference", p.difference()})
}

// difference is positive when the run is worse (CMP-004).
func (p *paired) difference() float64 {
	return meanOf(p.baseline).(float64) - meanOf(p.run).(float64)
}

// within reports whether `release` lets the difference pass.
func (p *paired) within(tolerance float64) bool {
	return len(p.run) == 0 || math.Abs(p.difference()) <= tolerance+1e-9
}

// Compare gives the members of schema ComparedRun that follow from the episodes, which have
// the same tasks in the same order in both runs.
func Compare(baseline, run []Graded, tolerance float64) wire.Object {
	var all paired
	var names []string
	byTask := map[string]*paired{}
	wins, losses, ties := 0, 0, 0
	for i, ours := range run {
		theirs := baseline[i]
		group := byTask[ours.Task]
		if group == nil {
			group = &paired{}
			byTask[ours.Task] = group
			names = append(names, ours.Task)
		}
		if ours.Outcome == "" || theirs.Outcome == "" { // CMP-002
			continue
		}
		for _, pairs := range []*paired{&all, group} {
			pairs.baseline = append(pairs.baseline, theirs.Score)
			pairs.run = append(pairs.run, ours.Score)
		}
		switch won, lost := ours.Outcome == "success", theirs.Outcome == "success"; { // CMP-006
		case won == lost:
			ties++
		case won:
			wins++
		default:
			losses++
		}
	}
	complete := len(all.run) == len(run) // CMP-003
	release := complete && all.within(tolerance)
	tasks := wire.Object{}
	for _, name := range names { // CMP-005
		tasks = append(tasks, wire.Member{name, byTask[name].means()})
		release = release && byTask[name].within(tolerance) // CMP-008
	}
	made := append(wire.Object{{"complete", complete}, {"release", release}}, all.means()...)
	return append(made, wire.Object{
		{"wins", wins}, {"losses", losses}, {"ties", ties},
		{"p_value", mcnemar(wins, losses)}, {"by_task", tasks},
	}...)
}

// mcnemar is the exact two-sided test (CMP-007), in whole numbers until the last division.
func mcnemar(wins, losses int) float64 {
	trials := int64(wins + losses)
	tail := new(big.Int)
	for k := range int64(min(wins, losses)) + 1 {
		tail.Add(tail, new(big.Int).Binomial(trials, k))
	}
	ways := new(big.Int).Lsh(big.NewInt(1), uint(trials))
	p, _ := new(big.Rat).SetFrac(tail.Lsh(tail, 1), ways).Float64()
	return min(1, p)
}
