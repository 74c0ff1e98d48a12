// The replay as a reader has it: its controls by their labels.

export class ReplayPart {
  constructor(page) {
    this.page = page;
    this.root = page.locator("#replay");
    this.canvas = this.root.getByRole("img", { name: /^3D replay of/ });
    this.time = this.root.getByRole("slider", { name: "Time" });
    this.values = this.root.locator(".replay-values");
    this.play = this.root.getByRole("button", { name: "Play", exact: true });
    this.pause = this.root.getByRole("button", { name: "Pause", exact: true });
    this.mode = this.root.getByLabel("Two runs");
  }

  async ready() {
    await this.root.scrollIntoViewIfNeeded();
    await this.canvas.waitFor();
    await this.canvas.scrollIntoViewIfNeeded();
  }

  /** Drags the slider to t [s], and waits until the picture is of that time. */
  async seek(t) {
    await this.time.fill(String(t));
    await this.waitFor(t);
  }

  async waitFor(t) {
    await this.page.waitForFunction(
      ([element, want]) => Math.abs(Number(element.textContent.match(/^t = ([\d.]+) s/)?.[1]) - want) < 0.03,
      [await this.values.elementHandle(), t],
    );
  }

  async now() {
    return Number((await this.values.textContent()).match(/^t = ([\d.]+) s/)?.[1]);
  }

  /** Position of the trunk of a run [m], as the values below the picture say. */
  async trunk(run = 0) {
    const all = [...(await this.values.textContent()).matchAll(/trunk at (-?[\d.]+), (-?[\d.]+), (-?[\d.]+) m/g)];
    return all[run]?.slice(1).map(Number);
  }

  /** Presses "Save picture"; the name that it suggests. */
  async savePicture(path) {
    const button = this.root.getByRole("button", { name: "Save picture" });
    const [download] = await Promise.all([this.page.waitForEvent("download"), button.click()]);
    await download.saveAs(path);
    return download.suggestedFilename();
  }

  async shot() {
    return this.canvas.screenshot();
  }
}
