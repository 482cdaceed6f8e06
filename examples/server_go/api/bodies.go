// Schemas of the request bodies, as openapi.yaml has them.
package api

import (
	"maps"
	"math"
	"regexp"

	"proctor-server-go/calibration"
	"proctor-server-go/wire"
)

var (
	namePattern     = regexp.MustCompile(`^[a-z][a-z0-9_]{0,63}$`)
	homepagePattern = regexp.MustCompile(`^https?://[!-~]+$`)
	idPattern       = regexp.MustCompile(`^[A-Za-z0-9_-]{1,64}$`)
	anyNumber       = wire.Number(math.Inf(-1), math.Inf(1))
	name            = wire.Text(1, 64, namePattern)
	sessionID       = wire.Text(1, 128, nil)
)

const unlimited = math.MaxInt32

var submitShape = wire.Record([]string{"benchmark_id", "policy"}, map[string]wire.Shape{
	"benchmark_id": name,
	"policy": wire.Record([]string{"name"}, map[string]wire.Shape{
		"name":      wire.Text(1, 200, nil),
		"version":   wire.Text(0, 200, nil),
		"submitter": wire.Text(0, 200, nil),
		"homepage":  wire.Text(0, 500, homepagePattern),
	}),
	"max_workers":    wire.Integer(1, 1024),
	"idle_timeout_s": wire.Number(1, 86400),
	"images": wire.Record([]string{"codec", "width", "height"}, map[string]wire.Shape{
		"codec": name, "width": wire.Integer(1, 4096), "height": wire.Integer(1, 4096),
	}),
	"options": wire.Record(nil, map[string]wire.Shape{
		"tasks":        wire.List(1, 1000, wire.OneOf(calibration.TaskNames...)),
		"max_steps":    wire.Integer(1, 10000),
		"success_rule": wire.OneOf("any_step", "last_step"),
		"max_attempts": wire.Integer(1, 10),
		"max_faults":   wire.Integer(1, 10),
		"queue_s":      wire.Number(0, 10),
	}),
	"mode": wire.OneOf("pull"), // the profile `push` is not offered, and so `policy_server` is not
})

var stopShape = wire.Record(nil, map[string]wire.Shape{"mode": wire.OneOf("abort", "drain")})

// conventions are the members that an assumption may have of a vector and of a part.
func conventions(more map[string]wire.Shape) wire.Shape {
	members := map[string]wire.Shape{
		"size": wire.Integer(1, math.MaxInt32), "quantity": name, "unit": wire.Text(0, 64, nil),
		"scale": anyNumber, "frame": wire.Text(0, 64, nil), "rotation": name, "relative_to": name,
		"gripper_open": anyNumber, "gripper_closed": anyNumber,
	}
	maps.Copy(members, more)
	return wire.Record(nil, members)
}

var assumption = conventions(map[string]wire.Shape{
	"parts": wire.MapOf(256, conventions(map[string]wire.Shape{"start": wire.Integer(0, math.MaxInt32)})),
})

var attachShape = wire.Record([]string{"attach_key"}, map[string]wire.Shape{
	"attach_key": wire.Text(1, 128, nil),
	"takeover":   wire.Boolean,
	"assumes": wire.Record(nil, map[string]wire.Shape{
		"control_rate_hz": wire.Number(0, math.Inf(1)),
		"action":          wire.MapOf(64, assumption),
		"state":           wire.MapOf(64, assumption),
	}),
})

var predictShape = wire.Record([]string{"session_id", "seq", "actions"}, map[string]wire.Shape{
	"session_id": sessionID,
	"seq":        wire.Integer(1, 1<<53-1),
	"actions": wire.List(1, unlimited, wire.Record([]string{"values"}, map[string]wire.Shape{
		"values": wire.MapOf(64, wire.List(0, 4096, anyNumber)),
	})),
	"observe": wire.OneOf("last", "all"),
})

var heartbeatShape = wire.Record([]string{"session_id"}, map[string]wire.Shape{
	"session_id": sessionID,
})
