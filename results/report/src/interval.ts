// The statistics that rows do not hold: over several rows at once. The same rule as in docs/metrics.md.

export type Interval = [number, number];

export const kLeastForInterval = 8;

export function median(values: readonly number[]): number {
  const ordered = [...values].sort((a, b) => a - b);
  const middle = (ordered.length - 1) / 2;
  const [low, high] = [ordered[Math.floor(middle)], ordered[Math.ceil(middle)]];
  return low === undefined || high === undefined ? NaN : (low + high) / 2;
}
