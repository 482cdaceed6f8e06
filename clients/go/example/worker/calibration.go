package worker

import "proctor"

// Act is one action of `calibration`; its success is a score above one half.
func Act(score float64) proctor.Action {
	success := 0.0
	if score > 0.5 {
		success = 1
	}
	return proctor.Action{Values: map[string][]float64{
		"score": {score}, "success": {success}, "end": {0}, "delay_s": {0}, "fault": {0},
		"vector": make([]float64, 8), "clipped": {0, 0},
	}}
}
