// A world in Go, written from spec/simulator.md alone: a point is pushed to a target.
//
//	go build -o go_world . && proctor-server --simulator ./go_world
//
// With an address it is started by hand, and plays as many worlds as servers ask for:
//
//	./go_world unix:/tmp/world.sock & proctor-server --simulator unix:/tmp/world.sock
package main

import (
	"io"
	"log"
	"math"
	"math/rand/v2"
	"net"
	"os"
	"strings"
)

const (
	near  = 0.05 // metres
	speed = 0.05 // metres in a step
)

type point [2]float64

// World has the state of one episode.
type World struct {
	position, target point
	isReset          bool
}

// A vector of two numbers in one part.
func pair(quantity, unit, frame string) Map {
	part := Map{"start": 0, "size": 2, "quantity": quantity, "unit": unit,
		"frame": frame, "rotation": "none", "relative_to": "none"}
	return Map{"size": 2, "parts": Map{"xy": part}, "out_of_range": "unbounded"}
}

func bounded(space Map) Map {
	space["minimum"], space["maximum"] = []any{-1.0, -1.0}, []any{1.0, 1.0}
	space["out_of_range"] = "clip"
	return space
}

var benchmark = Map{
	"benchmark_id": "go_world",
	"title":        "A point in the plane",
	"simulator":    Map{"name": "go_world", "version": "1"},
	"tasks":        []any{"reach"},
	"max_steps":    60,
	"action_space": Map{"velocity": bounded(pair("number", "1", "none"))},
	"observation_space": Map{
		"state": Map{
			"position": pair("position", "m", "world"),
			"target":   pair("position", "m", "world"),
		},
		"images": Map{"top": Map{"channels": 3, "description": "from above"}},
	},
	"image_sizes": []any{Map{"width": 64, "height": 64}},
}

func (w *World) state() Map {
	return Map{
		"position": []any{w.position[0], w.position[1]},
		"target":   []any{w.target[0], w.target[1]},
	}
}

func (w *World) reset(seed int64) Map {
	random := rand.New(rand.NewPCG(uint64(seed), 0))
	for _, p := range []*point{&w.position, &w.target} {
		p[0], p[1] = 2*random.Float64()-1, 2*random.Float64()-1
	}
	w.isReset = true
	return Map{"instruction": "Reach the red target.", "state": w.state()}
}

func (w *World) step(velocity []any) Map {
	for i := range w.position {
		moved := w.position[i] + speed*number(velocity[i])
		w.position[i] = math.Max(-1, math.Min(1, moved))
	}
	distance := math.Hypot(w.position[0]-w.target[0], w.position[1]-w.target[1])
	success := distance < near
	return Map{"state": w.state(), "success": success, "terminated": success,
		"reward": -distance}
}

func (w *World) observe(names []any, width, height int) Map {
	images := Map{}
	for _, name := range names {
		images[name.(string)] = Map{
			"shape": []any{height, width, 3},
			"data":  w.draw(width, height),
		}
	}
	return Map{"images": images}
}

func (w *World) draw(width, height int) []byte {
	pixels := make([]byte, width*height*3)
	for i := range pixels {
		pixels[i] = 240
	}
	for _, dot := range []struct {
		at     point
		colour [3]byte
	}{{w.target, [3]byte{200, 30, 30}}, {w.position, [3]byte{30, 30, 200}}} {
		x := int((dot.at[0] + 1) / 2 * float64(width-1))
		y := int((1 - dot.at[1]) / 2 * float64(height-1))
		for row := max(0, y-2); row <= min(height-1, y+2); row++ {
			for column := max(0, x-2); column <= min(width-1, x+2); column++ {
				copy(pixels[(row*width+column)*3:], dot.colour[:])
			}
		}
	}
	return pixels
}

func fault(text string) Map { return Map{"fault": text} }

func (w *World) answer(request Map) Map {
	call, _ := request["call"].(string)
	switch call {
	case "describe":
		return Map{"protocol": 1, "benchmark": benchmark}
	case "reset":
		if request["task"] != "reach" {
			return Map{"fault": "there is no such task", "unplayable": true}
		}
		return w.reset(int64(number(request["seed"])))
	case "close":
		return Map{}
	case "step", "observe":
		if !w.isReset {
			return fault(call + " before the first reset")
		}
	default:
		return fault("unknown call " + call)
	}
	if call == "step" {
		return w.step(request["action"].(Map)["velocity"].([]any))
	}
	names, _ := request["images"].([]any)
	return w.observe(names, int(number(request["width"])), int(number(request["height"])))
}

func play(input io.Reader, output io.Writer) {
	world := World{}
	for {
		request, err := receive(input)
		if err != nil {
			return // the end of the input
		}
		reply := world.answer(request)
		reply["number"] = request["number"]
		send(output, reply)
		if request["call"] == "close" {
			return
		}
	}
}

func main() {
	if len(os.Args) < 2 {
		play(os.Stdin, os.Stdout)
		return
	}
	path := strings.TrimPrefix(os.Args[1], "unix:")
	os.Remove(path)
	listener, err := net.Listen("unix", path)
	if err != nil {
		log.Fatal(err)
	}
	for {
		connection, err := listener.Accept()
		if err != nil {
			log.Fatal(err)
		}
		go func() {
			defer connection.Close()
			play(connection, connection)
		}()
	}
}
