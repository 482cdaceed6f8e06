// Shapes of request bodies: the schemas of openapi.yaml as small functions that report every
// faulty member with its JSON pointer (ERR-003, ERR-004). They know nothing of a run.
package wire

import (
	"fmt"
	"math"
	"regexp"
	"slices"
	"strconv"
	"strings"
	"unicode/utf8"
)

// Findings collects the first faults of a body.
type Findings struct {
	Faults []Fault
}

func (f *Findings) Add(pointer, detail string) {
	if len(f.Faults) < 20 {
		f.Faults = append(f.Faults, Fault{pointer, detail})
	}
}

type Shape func(pointer string, value any, found *Findings)

var pointerEscapes = strings.NewReplacer("~", "~0", "/", "~1")

func PointTo(pointer, name string) string {
	return pointer + "/" + pointerEscapes.Replace(name)
}

func Text(shortest, longest int, pattern *regexp.Regexp) Shape {
	return func(pointer string, value any, found *Findings) {
		text, isText := value.(string)
		length := utf8.RuneCountInString(text)
		switch {
		case !isText:
			found.Add(pointer, "must be a string")
		case length < shortest || length > longest:
			found.Add(pointer, fmt.Sprintf("must have %d to %d characters", shortest, longest))
		case pattern != nil && !pattern.MatchString(text):
			found.Add(pointer, "must match "+pattern.String())
		}
	}
}

func OneOf(values ...string) Shape {
	return func(pointer string, value any, found *Findings) {
		if text, isText := value.(string); !isText || !slices.Contains(values, text) {
			found.Add(pointer, "must be one of "+strings.Join(values, ", "))
		}
	}
}

func Boolean(pointer string, value any, found *Findings) {
	if _, isBool := value.(bool); !isBool {
		found.Add(pointer, "must be true or false")
	}
}

// Number refuses NaN and infinities, which MessagePack can carry (PRED-016).
func Number(lowest, highest float64) Shape {
	return func(pointer string, value any, found *Findings) {
		number, isNumber := value.(float64)
		switch {
		case !isNumber || math.IsNaN(number) || math.IsInf(number, 0):
			found.Add(pointer, "must be a finite number")
		case number < lowest || number > highest:
			found.Add(pointer, fmt.Sprintf("must be between %v and %v", lowest, highest))
		}
	}
}

func Integer(lowest, highest float64) Shape {
	inRange := Number(lowest, highest)
	return func(pointer string, value any, found *Findings) {
		if number, isNumber := value.(float64); isNumber && number != math.Trunc(number) {
			found.Add(pointer, "must be a whole number")
			return
		}
		inRange(pointer, value, found)
	}
}

func List(fewest, most int, item Shape) Shape {
	return func(pointer string, value any, found *Findings) {
		items, isList := value.([]any)
		if !isList || len(items) < fewest || len(items) > most {
			found.Add(pointer, fmt.Sprintf("must be a list of %d to %d items", fewest, most))
			return
		}
		for i, value := range items {
			item(pointer+"/"+strconv.Itoa(i), value, found)
		}
	}
}

func MapOf(most int, item Shape) Shape {
	return func(pointer string, value any, found *Findings) {
		members, isMap := value.(map[string]any)
		if !isMap || len(members) > most {
			found.Add(pointer, fmt.Sprintf("must be an object of at most %d members", most))
			return
		}
		for name, value := range members {
			item(PointTo(pointer, name), value, found)
		}
	}
}

// Record is an object with exactly these members, of which some are required.
func Record(required []string, shapes map[string]Shape) Shape {
	return func(pointer string, value any, found *Findings) {
		members, isObject := value.(map[string]any)
		if !isObject {
			found.Add(pointer, "must be an object")
			return
		}
		for _, name := range required {
			if _, there := members[name]; !there {
				found.Add(PointTo(pointer, name), "is required")
			}
		}
		for _, name := range SortedKeys(members) {
			if check, known := shapes[name]; known {
				check(PointTo(pointer, name), members[name], found)
			} else {
				found.Add(PointTo(pointer, name), "is not known here")
			}
		}
	}
}
