// The lifecycle of a run: the table x-lifecycle of openapi.yaml, and nothing else.
package runs

const (
	queued    = "queued"
	ready     = "ready"
	running   = "running"
	stopping  = "stopping"
	stopped   = "stopped"
	failed    = "failed"
	completed = "completed"
	refused   = "refused"
)

// Commands come from requests, events from inside.
const (
	commandAttach = "attach_worker"
	commandAbort  = "stop_abort"
	commandDrain  = "stop_drain"
	commandResume = "resume_run"
	eventCapacity = "capacity"
	eventIdle     = "last_lease_ends"
	eventScored   = "all_scored"
	eventFault    = "fault"
)

type transition struct {
	rule string
	to   string
}

var lifecycle = map[string]map[string]transition{
	queued: {
		commandAttach: {"LIFE-101", refused}, commandAbort: {"LIFE-102", stopped},
		commandDrain: {"LIFE-103", stopped}, commandResume: {"LIFE-104", queued},
		eventCapacity: {"LIFE-801", ready}, eventFault: {"LIFE-808", failed},
	},
	ready: {
		commandAttach: {"LIFE-201", running}, commandAbort: {"LIFE-202", stopped},
		commandDrain: {"LIFE-203", stopped}, commandResume: {"LIFE-204", ready},
		eventFault: {"LIFE-809", failed},
	},
	running: {
		commandAttach: {"LIFE-301", running}, commandAbort: {"LIFE-302", stopped},
		commandDrain: {"LIFE-303", stopping}, commandResume: {"LIFE-304", running},
		eventIdle: {"LIFE-802", ready}, eventScored: {"LIFE-804", completed},
		eventFault: {"LIFE-806", failed},
	},
	stopping: {
		commandAttach: {"LIFE-401", refused}, commandAbort: {"LIFE-402", stopped},
		commandDrain: {"LIFE-403", stopping}, commandResume: {"LIFE-404", refused},
		eventIdle: {"LIFE-803", stopped}, eventScored: {"LIFE-805", completed},
		eventFault: {"LIFE-807", failed},
	},
	stopped: {
		commandAttach: {"LIFE-501", refused}, commandAbort: {"LIFE-502", stopped},
		commandDrain: {"LIFE-503", stopped}, commandResume: {"LIFE-504", queued},
	},
	failed: {
		commandAttach: {"LIFE-601", refused}, commandAbort: {"LIFE-602", refused},
		commandDrain: {"LIFE-603", refused}, commandResume: {"LIFE-604", queued},
	},
	completed: {
		commandAttach: {"LIFE-701", refused}, commandAbort: {"LIFE-702", refused},
		commandDrain: {"LIFE-703", refused}, commandResume: {"LIFE-704", refused},
	},
}

// next is the only way to find the state that follows. A failed run that is not retryable
// refuses the resume that the table allows to others (LIFE-605).
func next(state, event string, retryable bool) transition {
	if state == failed && event == commandResume && !retryable {
		return transition{"LIFE-605", refused}
	}
	return lifecycle[state][event]
}
