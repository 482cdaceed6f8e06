/* The actions of the benchmark `calibration`, as spec/calibration.md has them. */

import type { Action } from "../src";

/** One action of `calibration`; its success is a score above one half. */
export function act(score: number, values: Record<string, number[]> = {}): Action {
  return {
    values: {
      score: [score], success: [score > 0.5 ? 1 : 0], end: [0], delay_s: [0], fault: [0],
      vector: Array(8).fill(0), clipped: [0, 0], ...values,
    },
  };
}
