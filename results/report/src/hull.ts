// A place on the ground, in the world [m].
export interface Point {
  readonly x: number;
  readonly y: number;
}

// Convex hull seen from above, counterclockwise (Andrew's monotone chain).
export function convexHull<P extends Point>(points: readonly P[]): P[] {
  const ordered = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  if (ordered.length < 3) return ordered;
  const half = (list: P[]): P[] => {
    const chain: P[] = [];
    for (const p of list) {
      while (chain.length > 1 && turn(chain[chain.length - 2]!, chain[chain.length - 1]!, p) <= 0) chain.pop();
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(ordered), ...half([...ordered].reverse())];
}

function turn(a: Point, b: Point, c: Point): number {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
