// What the tests read from a page.
import assert from "node:assert/strict";

/** Brings a plot into view and waits until it is drawn. */
export async function drawn(page, id) {
  const figure = page.locator(`figure[data-plot="${id}"]:visible`).first();
  await figure.scrollIntoViewIfNeeded();
  await page.waitForFunction((f) => f.dataset.state !== undefined, await figure.elementHandle());
  return figure;
}

/** What plotly holds of a drawn plot: per trace its name, mode and x axis, how many points are numbers, its range in y. */
export function plotted(figure) {
  return figure.evaluate((element) => {
    const plot = element.querySelector(".js-plotly-plot");
    return (plot?.data ?? []).map((trace) => {
      const y = Array.from(trace.y ?? []).filter((v) => typeof v === "number" && Number.isFinite(v));
      return { name: trace.name ?? "", mode: trace.mode ?? trace.type, axis: trace.xaxis ?? "x", points: y.length, low: Math.min(...y), high: Math.max(...y) };
    });
  });
}

/** Fails unless at least `least` lines of the plot have points that are not all the same. */
export async function assertHasData(page, id, least = 1, points = 20) {
  const figure = await drawn(page, id);
  assert.equal(await figure.getAttribute("data-state"), "drawn", `${id}: ${await figure.innerText()}`);
  const traces = await plotted(figure);
  const alive = traces.filter((trace) => trace.points >= points && trace.high > trace.low);
  assert.ok(alive.length >= least, `${id}: ${alive.length} of ${traces.length} lines have data: ${JSON.stringify(traces)}`);
  return traces;
}

/** `shown` is `value` with three significant digits. */
export function assertRounded(shown, value, what) {
  assert.ok(Math.abs(shown - value) <= 0.00501 * Math.abs(value), `${what}: ${shown} is shown, not ${value}`);
}

/** Share of the pixels in which two PNGs of one size differ clearly. */
export function difference(page, one, other) {
  return page.evaluate(
    async ([a, b]) => {
      const pixels = async (text) => {
        const image = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]));
        const canvas = new OffscreenCanvas(image.width, image.height);
        const pen = canvas.getContext("2d");
        pen.drawImage(image, 0, 0);
        return pen.getImageData(0, 0, image.width, image.height).data;
      };
      const [p, q] = [await pixels(a), await pixels(b)];
      if (p.length !== q.length) return 1;
      let different = 0;
      for (let i = 0; i < p.length; i += 4) {
        different += Math.abs(p[i] - q[i]) + Math.abs(p[i + 1] - q[i + 1]) + Math.abs(p[i + 2] - q[i + 2]) > 40;
      }
      return (4 * different) / p.length;
    },
    [one.toString("base64"), other.toString("base64")],
  );
}

/** Presses Tab until the element has the focus, as a reader without a mouse does. */
export async function tabTo(page, locator, most = 400) {
  for (let i = 0; i < most; ++i) {
    if (await locator.evaluate((element) => element === document.activeElement)) return;
    await page.keyboard.press("Tab");
  }
  assert.fail(`Tab does not reach ${locator}`);
}

/** Nothing is wider than the window. */
export async function assertNoOverflow(page) {
  const { content, window, widest } = await page.evaluate(() => {
    const room = document.documentElement.clientWidth;
    const outside = [...document.querySelectorAll("body *")].filter((e) => e.getBoundingClientRect().right > room + 1);
    return {
      content: document.documentElement.scrollWidth,
      window: room,
      widest: outside.slice(0, 5).map((e) => `${e.tagName}.${e.className}`),
    };
  });
  assert.ok(content <= window, `the page is ${content} px wide in a window of ${window} px: ${widest.join(", ")}`);
}
