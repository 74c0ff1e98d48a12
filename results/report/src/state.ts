// What parts of the page share: values that tell their subscribers when they change.

export interface Signal<T> {
  get(): T;
  set(value: T): void;
  // Calls `listener` at every change from now on (not at once); returns what ends that.
  subscribe(listener: (value: T) => void): () => void;
}

export function signal<T>(initial: T): Signal<T> {
  let value = initial;
  const listeners = new Set<(value: T) => void>();
  return {
    get: () => value,
    set(next) {
      if (Object.is(next, value)) return;
      value = next;
      for (const listener of [...listeners]) listener(value);
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}

// The cursor [s] of the plots over time and of the replay.
export const time: Signal<number> = signal(0);

// The stretch of time [s] that the plots over time show; null is all of it.
export const timeRange: Signal<readonly [number, number] | null> = signal<readonly [number, number] | null>(null);

export type Theme = "light" | "dark";
export const theme: Signal<Theme> = signal<Theme>("light");
