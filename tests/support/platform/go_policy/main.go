// A policy server in Go, for a sandbox whose root has no other file.
package main

import (
	"encoding/json"
	"fmt"
	"net"
	"net/http"
	"os"
)

type space struct {
	Size    int       `json:"size"`
	Minimum []float64 `json:"minimum"`
}

type request struct {
	SessionID string `json:"session_id"`
	Seq       int    `json:"seq"`
	Benchmark struct {
		ActionSpace map[string]space `json:"action_space"`
	} `json:"benchmark"`
	Episode struct {
		EpisodeID string `json:"episode_id"`
		Attempt   int    `json:"attempt"`
	} `json:"episode"`
}

func main() {
	var actions map[string]space
	answer := func(writer http.ResponseWriter, body any) {
		writer.Header().Set("Content-Type", "application/json")
		json.NewEncoder(writer).Encode(body)
	}
	read := func(incoming *http.Request) (body request) {
		json.NewDecoder(incoming.Body).Decode(&body)
		return body
	}
	http.HandleFunc("GET /v1/policy", func(writer http.ResponseWriter, _ *http.Request) {
		protocol := map[string]string{"min": "1.0", "max": "1.0"}
		answer(writer, map[string]any{"name": "go", "protocol": protocol, "max_sessions": 1})
	})
	http.HandleFunc("POST /v1/policy/reset", func(writer http.ResponseWriter, incoming *http.Request) {
		body := read(incoming)
		actions = body.Benchmark.ActionSpace
		answer(writer, map[string]any{"session_id": body.SessionID,
			"episode_id": body.Episode.EpisodeID, "attempt": body.Episode.Attempt})
	})
	http.HandleFunc("POST /v1/policy/predict", func(writer http.ResponseWriter, incoming *http.Request) {
		body, values := read(incoming), map[string][]float64{}
		for name, described := range actions {
			values[name] = make([]float64, described.Size)
			copy(values[name], described.Minimum)
		}
		values["end"] = []float64{1}
		fmt.Println("predict", body.Seq)
		answer(writer, map[string]any{"session_id": body.SessionID, "seq": body.Seq + 1,
			"actions": []any{map[string]any{"values": values}}})
	})
	listener, err := net.Listen("unix", os.Getenv("PROCTOR_POLICY_SOCKET"))
	if err != nil {
		panic(err)
	}
	panic(http.Serve(listener, nil))
}
