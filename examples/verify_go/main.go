// Verifies records of Proctor runs, from spec/profiles/record.md alone:
//
//	verify-go [--key NAME=SHA256:…]… FILE…
//
// prints a line of JSON for each file: its levels, or the file and the rule of the first
// thing that is wrong. Exit code 0 if nothing is wrong, 1 otherwise, 2 for wrong usage.
package main

import (
	"encoding/json"
	"fmt"
	"os"
	"strings"
)

// answer is what is printed of one record.
type answer struct {
	Record string   `json:"record"`
	Levels []string `json:"levels"`
	File   *string  `json:"file"`
	Rule   *string  `json:"rule"`
	Detail string   `json:"detail,omitempty"`
}

func main() {
	keys := map[string]string{}
	arguments := os.Args[1:]
	for len(arguments) > 1 && arguments[0] == "--key" {
		name, keyid, found := strings.Cut(arguments[1], "=")
		if !found {
			usage()
		}
		keys[keyid] = name
		arguments = arguments[2:]
	}
	if len(arguments) == 0 {
		usage()
	}
	code := 0
	for _, path := range arguments {
		line, failed := describe(path, keys)
		if failed {
			code = 1
		}
		text, _ := json.Marshal(line)
		fmt.Println(string(text))
	}
	os.Exit(code)
}

func usage() {
	fmt.Fprintln(os.Stderr, "usage: verify-go [--key NAME=SHA256:…]… FILE…")
	os.Exit(2)
}

func describe(path string, keys map[string]string) (answer, bool) {
	levels, err := verify(path, keys)
	if err == nil {
		return answer{Record: path, Levels: levels}, false
	}
	line := answer{Record: path, Levels: []string{}, Detail: err.Error()}
	if broken, is := err.(*broken); is {
		line.File, line.Rule, line.Detail = &broken.file, &broken.rule, broken.detail
	}
	return line, true
}
