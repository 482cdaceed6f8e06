// All runs, and the journal that they are restored from: one JSON document per line, appended before the answer.
import { randomBytes } from 'node:crypto';
import { EventEmitter } from 'node:events';
import { existsSync, fdatasyncSync, mkdirSync, openSync, readFileSync, writeSync } from 'node:fs';
import { dirname } from 'node:path';
import { chooseImages } from './calibration.js';
import { fingerprint } from './json.js';
import { Problem, invalid } from './problems.js';
import { Run } from './run.js';
import { LIMITS } from './shapes.js';

export class RunRegistry {
  constructor(path) {
    this.runs = new Map(); // run id → run, oldest first
    this.keys = new Map(); // account and Idempotency-Key → run
    this.changes = new EventEmitter().setMaxListeners(0);
    if (path) this.restore(path);
  }

  restore(path) {
    mkdirSync(dirname(path), { recursive: true });
    const lines = existsSync(path) ? readFileSync(path, 'utf8').split('\n') : [];
    const whole = lines.slice(0, -1); // a line that was being written when the server died was not answered yet
    for (const line of whole.filter(Boolean)) this.apply(line);
    this.file = openSync(path, 'a');
    if (lines.at(-1)) writeSync(this.file, '\n');
    for (const run of this.runs.values()) if (run.state === 'queued') run.queue();
  }

  apply(line) {
    let entry;
    try {
      entry = JSON.parse(line);
    } catch {
      return; // the torn line of an earlier death
    }
    if (entry.submit) this.add(entry);
    else this.runs.get(entry.run_id).restore(entry);
  }

  keep(entry) {
    if (this.file === undefined) return;
    writeSync(this.file, `${JSON.stringify(entry)}\n`);
    fdatasyncSync(this.file);
  }

  add(record) {
    const run = new Run(record, (entry) => this.keep(entry), () => this.changes.emit('change'));
    this.runs.set(record.run_id, run);
    if (record.key) this.keys.set(JSON.stringify([record.account, record.key]), run);
    return run;
  }

  submit(account, key, submit) {
    const known = key && this.keys.get(JSON.stringify([account, key]));
    if (known && fingerprint(known.record.submit) !== fingerprint(submit)) throw new Problem('idempotency_conflict');
    if (known) return known;
    const { idle_timeout_s_min: least, idle_timeout_s_max: most } = LIMITS;
    const { max_workers = LIMITS.max_workers, idle_timeout_s = most } = submit;
    if (submit.benchmark_id !== 'calibration') throw invalid(['/benchmark_id', 'is not offered here']);
    if (max_workers > LIMITS.max_workers) throw invalid(['/max_workers', `at most ${LIMITS.max_workers}`]);
    if (idle_timeout_s < least || idle_timeout_s > most) throw invalid(['/idle_timeout_s', `from ${least} to ${most}`]);
    const record = {
      run_id: randomBytes(12).toString('base64url'), account, key, submit, max_workers, idle_timeout_s,
      images: chooseImages(submit.images), number: this.runs.size + 1, created_at: new Date().toISOString(),
    };
    this.keep(record);
    const run = this.add(record);
    run.queue();
    return run;
  }

  find(account, id) {
    const run = this.runs.get(id);
    if (run?.record.account !== account) throw new Problem('not_found');
    return run;
  }

  queuePosition(run) {
    if (run.state !== 'queued') return null;
    return [...this.runs.values()].filter(({ state }) => state === 'queued').indexOf(run) + 1;
  }
}
