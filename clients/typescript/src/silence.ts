/* Why the server did not hear from a worker for longer than its lease.
 *
 * A session that ends so costs the attempt of its episode, and nothing else shows it: the worker
 * attaches again and plays on. The cause is measured here, not guessed.
 */

export type Cause = "standstill" | "suspended" | "unreached" | "request";

const CAUSES: Record<Cause, string> = {
  standstill: "this program stood still",
  suspended: "this machine was suspended",
  unreached: "the server was not reached",
  request: "a request had no answer",
};
const CURES: Record<Cause, (lease: string) => string> = {
  standstill: (lease) =>
    "A function that keeps the thread busy, also that of another worker, stops the heartbeats that extend the lease; " +
    `so does a machine that swaps, or that suspends this program. Compute in a worker thread, or give a new run a longer lease (${lease}).`,
  suspended: (lease) =>
    "Keep the machine awake while a run is played (`systemd-inhibit` or `caffeinate` before the command), " +
    `or give a new run a longer lease (${lease}).`,
  unreached: (lease) => `A new run with a longer lease (${lease}) outlives such a cut.`,
  request: (lease) => `The network, a proxy or the server held it back; a new run with a longer lease (${lease}) outlives that.`,
};

/** A session that has ended because its worker was silent for too long.
 *
 * step: at which the episode was lost; 0 costs no attempt. silentS: how long the server heard nothing.
 */
export interface LostSession {
  workerId: string;
  episodeId: string;
  step: number;
  attempt: number;
  leaseS: number;
  silentS: number;
  cause: Cause;
}

export function describe({ workerId, episodeId, step, attempt, leaseS, silentS, cause }: LostSession): string {
  const what = step === 0 ? `its session before the first step of ${episodeId}` : `attempt ${attempt} of ${episodeId} at step ${step}`;
  // An answer that was read late hides when the silence began.
  const time = silentS < leaseS ? `longer than its lease of ${leaseS} s` : `${silentS.toFixed(1)} s, and the lease is ${leaseS} s`;
  return `${workerId} lost ${what}: ${CAUSES[cause]} for ${time}`;
}

/** All losses of an evaluation in a few sentences, with what to do about them. */
export function summary(lost: LostSession[], abandoned: number): string {
  const counted = (count: number, what: string) => `${count} ${what}${count === 1 ? "" : "s"}`;
  const workers = new Set(lost.map(({ workerId }) => workerId)).size;
  const attempts = lost.filter(({ step }) => step > 0).length;
  const sentences = [
    `Lost by silence: ${counted(lost.length, "session")} of ${counted(workers, "worker")}, and with them ${counted(attempts, "attempt")}.`,
  ];
  if (abandoned) {
    const have = abandoned === 1 ? "has no attempt left and counts 0" : "have no attempt left and count 0";
    sentences.push(`${counted(abandoned, "episode")} ${have}.`);
  }
  const longestS = Math.max(...lost.map(({ silentS, leaseS }) => Math.max(silentS, leaseS)));
  const lease = `idleTimeoutS: ${Math.ceil(longestS / 5) * 10}`;
  for (const cause of new Set(lost.map((session) => session.cause))) sentences.push(CURES[cause](lease));
  return sentences.join(" ");
}

/** Measures since the server's last answer. */
export class SilenceMeter {
  private at!: number;
  private awakeAt!: number;
  private sentAt?: number;
  private isUnreached!: boolean;

  /** awakeS: a clock that stands still while the machine is suspended, where there is one; wallS goes on. */
  constructor(private readonly awakeS = () => performance.now() / 1000, private readonly wallS = () => Date.now() / 1000) {
    this.answered();
  }

  /** The server has answered: a lease begins. */
  answered(): void {
    [this.at, this.awakeAt, this.sentAt, this.isUnreached] = [this.wallS(), this.awakeS(), undefined, false];
  }

  /** A request other than a heartbeat begins. */
  sent(): void {
    this.sentAt = this.awakeS();
  }

  /** A heartbeat begins; the result says how it ended, which a busy thread learns late. */
  heartbeat(timeoutS: number): { answered: () => void; failed: () => void } {
    const [wall, awake] = [this.wallS(), this.awakeS()];
    return {
      answered: () => {
        if (awake > this.awakeAt) [this.at, this.awakeAt, this.isUnreached] = [wall, awake, false];
      },
      failed: () => {
        if (awake > this.awakeAt && this.awakeS() - awake < 2 * timeoutS) this.isUnreached = true;
      },
    };
  }

  /** How long the server has heard nothing, and the most likely cause. */
  silence(leaseS: number): { silentS: number; cause: Cause } {
    const [silentS, awake] = [this.wallS() - this.at, this.awakeS()];
    const isWaiting = this.sentAt !== undefined && awake - this.sentAt > leaseS / 2;
    if (silentS - (awake - this.awakeAt) > leaseS / 2) return { silentS, cause: "suspended" };
    if (this.isUnreached) return { silentS, cause: "unreached" };
    return { silentS, cause: isWaiting ? "request" : "standstill" };
  }
}
