/* What a program waits for, on stderr: after 2 s, and then every 10 s. */

const FIRST_MS = 2000;
const NEXT_MS = 10_000;
const SILENT_MS = 12_000; // longer than a long poll

/* Workers that wait for the same thing say it once. */
const said = { line: "", at: -Infinity };

/** The `onWaiting` of one request that is repeated; null ends it. */
export function reportWait(url: string): (why: string | null) => void {
  let reason: string | null = null;
  const repeat = () => {
    const line = `waiting: ${reason ?? `${url} has not answered yet.`}`;
    if (line !== said.line || performance.now() - said.at > NEXT_MS / 2) {
      [said.line, said.at] = [line, performance.now()];
      console.error(line);
    }
    timer = setTimeout(repeat, NEXT_MS).unref();
  };
  let timer = setTimeout(repeat, SILENT_MS).unref();
  return (why) => {
    if (reason === null || why === null) clearTimeout(timer);
    if (reason === null && why !== null) timer = setTimeout(repeat, FIRST_MS).unref();
    reason = why;
  };
}
