// Verifies records of Proctor runs, from spec/profiles/record.md alone:
//
//	verify-go [--key [NAME=]SHA256:…]… FILE…
//
// prints a line of JSON for each file: its levels, or the file and the rule of the first
// thing that is wrong. A record that none of the keys named has signed is wrong. Exit code
// 0 if nothing is wrong, 1 otherwise, 2 for wrong usage and for a file that cannot be read.
package main

import (
	"encoding/json"
	"fmt"
	"os"
	"regexp"
	"strings"
)

var keyForm = regexp.MustCompile(`^(?:([^=]{1,64})=)?(SHA256:[0-9a-f]{64})$`)

// answer is what is printed of one record.
type answer struct {
	Record string   `json:"record"`
	Levels []string `json:"levels"`
	File   *string  `json:"file"`
	Rule   *string  `json:"rule"`
	Detail string   `json:"detail,omitempty"`
}

func main() {
	keys, paths := readArguments(os.Args[1:])
	code := 0
	for _, path := range paths {
		line, failed := describe(path, keys)
		code = max(code, failed)
		text, _ := json.Marshal(line)
		fmt.Println(string(text))
	}
	os.Exit(code)
}

// readArguments gives keyid → whose key it is, and the files; keys may stand behind files.
func readArguments(arguments []string) (keys map[string]string, paths []string) {
	keys = map[string]string{}
	for i := 0; i < len(arguments); i++ {
		text, isKey := strings.CutPrefix(arguments[i], "--key=")
		if arguments[i] == "--key" && i+1 < len(arguments) {
			i++
			text, isKey = arguments[i], true
		}
		form := keyForm.FindStringSubmatch(text)
		switch {
		case isKey && form == nil:
			usage("--key " + text + ": expected SHA256:… with 64 hexadecimal digits, or NAME=SHA256:…")
		case isKey && form[1] == "":
			keys[form[2]] = "the owner of " + form[2][:15] + "…"
		case isKey:
			keys[form[2]] = form[1]
		case strings.HasPrefix(text, "--"):
			usage("unknown option " + text)
		default:
			paths = append(paths, text)
		}
	}
	if len(paths) == 0 {
		usage("no file is named")
	}
	return keys, paths
}

func usage(why string) {
	fmt.Fprintln(os.Stderr, "verify-go:", why)
	fmt.Fprintln(os.Stderr, "usage: verify-go [--key [NAME=]SHA256:…]… FILE…")
	os.Exit(2)
}

// describe gives what is printed of a record, and the exit code that follows from it.
func describe(path string, keys map[string]string) (answer, int) {
	levels, err := verify(path, keys)
	if err == nil {
		return answer{Record: path, Levels: levels}, 0
	}
	if broken, is := err.(*broken); is {
		return answer{Record: path, Levels: []string{}, File: &broken.file, Rule: &broken.rule, Detail: broken.detail}, 1
	}
	return answer{Record: path, Levels: []string{}, Detail: err.Error()}, 2
}
