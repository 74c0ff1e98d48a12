// The statistics that rows do not hold: over several rows at once. The same rules as in docs/metrics.md.

export type Interval = [number, number];

export const kLeastForInterval = 8;

const kZ = 1.959964;

// Wilson score interval, 95 %, of `count` of `total`; null below 8.
export function wilson(count: number, total: number): Interval | null {
  if (total < kLeastForInterval) return null;
  const p = count / total;
  const z2 = (kZ * kZ) / total;
  const centre = (p + z2 / 2) / (1 + z2);
  const half = (kZ / (1 + z2)) * Math.sqrt((p * (1 - p)) / total + z2 / (4 * total));
  return [Math.max(0, centre - half), Math.min(1, centre + half)];
}

export function median(values: readonly number[]): number {
  const ordered = [...values].sort((a, b) => a - b);
  const middle = (ordered.length - 1) / 2;
  const [low, high] = [ordered[Math.floor(middle)], ordered[Math.ceil(middle)]];
  return low === undefined || high === undefined ? NaN : (low + high) / 2;
}
