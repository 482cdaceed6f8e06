package main

import (
	"fmt"
	"math"
)

const (
	tolerance = 1e-9
	z95       = 1.959963984540054
)

// group counts episodes; scoring.md has the names.
type group struct {
	total, success, failure, abandoned int
	sum                                float64
}

func (g *group) add(line *object) {
	g.total++
	if !line.has("outcome") {
		return
	}
	g.sum += line.number("score")
	switch line.text("outcome") {
	case "success":
		g.success++
	case "failure":
		g.failure++
	default:
		g.abandoned++
	}
}

func (g *group) scored() int { return g.success + g.failure + g.abandoned }

// over is value divided by count, nil for none.
func over(value float64, count int) any {
	if count == 0 {
		return nil
	}
	return value / float64(count)
}

func (g *group) members() map[string]any {
	return map[string]any{
		"counts": map[string]any{
			"total": float64(g.total), "success": float64(g.success),
			"failure": float64(g.failure), "abandoned": float64(g.abandoned),
			"unscored": float64(g.total - g.scored()),
		},
		"mean":         over(g.sum, g.scored()),
		"success_rate": over(float64(g.success), g.scored()),
	}
}

func wilson(rate any, n int) map[string]any {
	p, has := rate.(float64)
	if !has {
		return map[string]any{"low": 0.0, "high": 1.0}
	}
	size, z2 := float64(n), z95*z95
	centre := (p + z2/(2*size)) / (1 + z2/size)
	half := z95 / (1 + z2/size) * math.Sqrt(max(0, p*(1-p))/size+z2/(4*size*size))
	return map[string]any{"low": max(0, centre-half), "high": min(1, centre+half)}
}

// computeScore gives the members of a score that follow from the lines (REC-013).
func computeScore(lines []*object) map[string]any {
	all, tasks, splits := &group{}, map[string]*group{}, map[string]*group{}
	for _, line := range lines {
		all.add(line)
		named(tasks, line.text("task")).add(line)
		named(splits, line.text("split")).add(line)
	}
	total, n := float64(all.total), all.scored()
	score := all.members()
	score["complete"] = n == all.total
	score["score"] = nil
	if n == all.total {
		score["score"] = all.sum / total
	}
	score["score_low"] = all.sum / total
	score["score_high"] = (all.sum + total - float64(n)) / total
	score["success_interval"] = wilson(score["success_rate"], n)
	score["mean_interval"] = wilson(score["mean"], n)
	score["by_task"], score["by_split"] = membersOf(tasks), membersOf(splits)
	return score
}

func named(groups map[string]*group, name string) *group {
	if groups[name] == nil {
		groups[name] = &group{}
	}
	return groups[name]
}

func membersOf(groups map[string]*group) map[string]any {
	found := map[string]any{}
	for name, one := range groups {
		found[name] = one.members()
	}
	return found
}

// differ names the first member of expected that found has otherwise, "" for none. Only
// at the top may found have members of its own.
func differ(expected, found any, path string) string {
	wanted, is := expected.(map[string]any)
	if !is {
		if number, both := expected.(float64); both {
			got, is := found.(float64)
			both = is && math.Abs(number-got) <= tolerance
			if both {
				return ""
			}
		} else if expected == found {
			return ""
		}
		return fmt.Sprintf("%s is %v, not %v", path, found, expected)
	}
	got, is := found.(map[string]any)
	if !is || (path != "" && len(got) != len(wanted)) {
		return path + " has other members"
	}
	for name, value := range wanted {
		if difference := differ(value, got[name], path+"/"+name); difference != "" {
			return difference
		}
	}
	return ""
}
