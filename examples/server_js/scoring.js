// spec/scoring.md: results in, numbers out.

const Z = 1.959963984540054;

/** A thousand scores between 0 and 1 lose 1e-13 at most; SCORE-006 allows ten times that. */
const sum = (values) => values.reduce((total, value) => total + value, 0);

/** The Wilson interval of the rate p over n trials. */
function wilson(p, n) {
  if (n === 0) return { low: 0, high: 1 };
  const scale = 1 + Z ** 2 / n;
  const centre = (p + Z ** 2 / (2 * n)) / scale;
  const half = (Z / scale) * Math.sqrt((p * (1 - p)) / n + Z ** 2 / (4 * n ** 2));
  return { low: Math.max(0, centre - half), high: Math.min(1, centre + half) };
}

function summary(episodes) {
  const results = episodes.filter(({ result }) => result).map(({ result }) => result);
  const counts = { total: episodes.length, success: 0, failure: 0, abandoned: 0, unscored: episodes.length - results.length };
  for (const { outcome } of results) counts[outcome] += 1;
  const n = results.length;
  const scored = sum(results.map(({ score }) => score));
  return { counts, scored, n, mean: n ? scored / n : null, success_rate: n ? counts.success / n : null };
}

function groups(episodes, member) {
  const names = [...new Set(episodes.map((episode) => episode[member]))];
  const numbers = names.map((name) => {
    const { counts, mean, success_rate } = summary(episodes.filter((episode) => episode[member] === name));
    return [name, { counts, mean, success_rate }];
  });
  return Object.fromEntries(numbers);
}

export function score(episodes) {
  const total = episodes.length;
  const { counts, scored, n, mean, success_rate } = summary(episodes);
  return {
    complete: n === total,
    score: n === total ? scored / total : null,
    score_low: scored / total,
    score_high: (scored + total - n) / total,
    counts, mean, success_rate, success_interval: wilson(success_rate, n), mean_interval: wilson(mean, n),
    by_task: groups(episodes, 'task'), by_split: groups(episodes, 'split'),
  };
}
