package worker

import (
	"fmt"
	"os"
	"sync"
	"time"
)

const (
	firstReport = 2 * time.Second
	nextReport  = 10 * time.Second
)

// waitReport says on stderr why a request is still not answered.
type waitReport struct {
	lock  sync.Mutex
	why   string
	timer *time.Timer
}

func reportWait() *waitReport {
	r := &waitReport{why: "an answer"}
	r.lock.Lock()
	defer r.lock.Unlock()
	r.timer = time.AfterFunc(firstReport, func() {
		r.lock.Lock()
		defer r.lock.Unlock()
		fmt.Fprintf(os.Stderr, "waiting: %s\n", r.why)
		r.timer.Reset(nextReport)
	})
	return r
}

func (r *waitReport) because(err error) {
	r.lock.Lock()
	defer r.lock.Unlock()
	r.why = err.Error()
}

func (r *waitReport) end() {
	r.lock.Lock()
	defer r.lock.Unlock()
	r.timer.Stop()
}
