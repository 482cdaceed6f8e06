// Observations of the benchmark `calibration`: states, the image `pattern` in the codec and
// size of the run, and tensors; with the time that rendering and encoding take.
package calibration

import (
	"bytes"
	"image"
	"image/color"
	"image/jpeg"
	"image/png"
	"slices"
	"time"

	"proctor-server-go/wire"
)

// ImageChoice is the run's, recorded with its result.
type ImageChoice struct {
	Codec  string `json:"codec"`
	Width  int    `json:"width"`
	Height int    `json:"height"`
}

var DefaultImages = ImageChoice{CodecNames[0], imageSizes[0][0], imageSizes[0][1]}

func (c ImageChoice) Object() wire.Object {
	return wire.Object{{"codec", c.Codec}, {"width", c.Width}, {"height", c.Height}}
}

// Faults points at what the benchmark does not offer (RUN-017).
func (c ImageChoice) Faults(found *wire.Findings) {
	if !slices.Contains(CodecNames, c.Codec) {
		found.Add("/images/codec", "is no codec of the benchmark")
	}
	if !slices.Contains(imageSizes, [2]int{c.Width, c.Height}) {
		found.Add("/images/width", "with height, is no image size of the benchmark")
	}
}

// Stopwatch adds up where the time of a turn goes.
type Stopwatch struct {
	Begun                    time.Time
	Simulate, render, encode time.Duration
}

func (w *Stopwatch) Timing() wire.Object {
	return wire.Object{
		{"total_s", time.Since(w.Begun).Seconds()}, {"queue_s", 0.0},
		{"simulate_s", w.Simulate.Seconds()}, {"render_s", w.render.Seconds()},
		{"encode_s", w.encode.Seconds()},
	}
}

func Observe(s *Simulator, choice ImageChoice, watch *Stopwatch) wire.Object {
	images, arrays := wire.Object{}, wire.Object{}
	if s.task == "echo" {
		images = wire.Object{{"pattern", choice.pattern(s.Count, watch)}}
		for _, t := range tensors { // ENC-004
			arrays = append(arrays, wire.Member{t.name, wire.Object{
				{"dtype", t.dtype}, {"shape", t.shape}, {"data", t.data},
			}})
		}
	}
	state := wire.Object{
		{"count", []float64{float64(s.Count)}}, {"vector", s.vector}, {"clipped", s.clipped},
	}
	return wire.Object{{"state", state}, {"images", images}, {"tensors", arrays}}
}

func (c ImageChoice) pattern(count int, watch *Stopwatch) wire.Object {
	begun := time.Now()
	raw := make([]byte, 0, c.Width*c.Height*3)
	for y := range c.Height {
		for x := range c.Width {
			for channel := range 3 {
				raw = append(raw, byte(7*x+13*y+29*channel+count)) // ENC-005
			}
		}
	}
	rendered := time.Now()
	data := c.encode(raw)
	watch.render += rendered.Sub(begun)
	watch.encode += time.Since(rendered)
	return append(c.Object(), wire.Member{"channels", 3}, wire.Member{"data", data})
}

// encode turns rows of RGB into the run's codec (ENC-006, ENC-007).
func (c ImageChoice) encode(raw []byte) []byte {
	if c.Codec == "raw" {
		return raw
	}
	picture := image.NewRGBA(image.Rect(0, 0, c.Width, c.Height))
	for i := range c.Width * c.Height {
		picture.Set(i%c.Width, i/c.Width, color.RGBA{raw[3*i], raw[3*i+1], raw[3*i+2], 255})
	}
	var out bytes.Buffer
	var err error
	if c.Codec == "png" {
		err = png.Encode(&out, picture)
	} else {
		err = jpeg.Encode(&out, picture, &jpeg.Options{Quality: 95})
	}
	if err != nil {
		panic(err) // a buffer takes every byte
	}
	return out.Bytes()
}
