/* Plays the benchmark `calibration` with a scripted policy, or goes on with a run:
 *
 *     npm ci && npm run build
 *     PROCTOR_TOKEN=… node dist/clients/typescript/example/evaluate.js URL [RUN_ID]
 */

import { ProctorError, evaluate, type Action, type Observation, type Policy } from "../src";

/** Your network goes here. `calibration` scores what the action says. */
class ScriptedPolicy implements Policy {
  act(observation: Observation): Action[] {
    const score = (observation.turn.episode!.index % 5) / 4;
    const rest = { success: [score > 0.5 ? 1 : 0], end: [0], delay_s: [0], fault: [0] };
    return Array(5).fill({ score: [score], ...rest, vector: new Float64Array(8), clipped: [0, 0] });
  }
}

async function main(url: string, token: string, runId?: string): Promise<void> {
  const score = await evaluate({
    url, token, runId,
    benchmark: "calibration",
    calibration: { tasks: Array(8).fill("score"), max_steps: 20 },
    policy: () => new ScriptedPolicy(),
    name: "scripted",
    workers: 2,
    onRun: (run) => console.log(`run ${run.run_id}: ${run.progress.episodes_total} episodes`),
    onResult: (r) => console.log(`  episode ${r.index} (${r.task}): ${r.outcome}, score ${r.score}`),
  });
  console.log(`score ${score.score}`);
}

const [url, runId] = process.argv.slice(2);
const token = process.env.PROCTOR_TOKEN;
if (!url || !token) {
  console.error("usage: node evaluate.js URL [RUN_ID]; the token is PROCTOR_TOKEN");
  process.exit(1);
}
main(url, token, runId).catch((error) => {
  console.error(error instanceof ProctorError ? error.message : error);
  process.exitCode = 1;
});
