// Chromium, driven by playwright-core, with eyes on everything that a page must not do.
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const { chromium, selectors } = createRequire(new URL("../../results/report/package.json", import.meta.url))("playwright-core");
selectors.setTestIdAttribute("data-test");

// WebGL by the processor; the rest of the page without it, which is faster there.
const kSoftwareGl = ["--disable-gpu-compositing", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
// What the software renderer says of itself when its picture is copied; the page cannot avoid it.
const kOfDriver = /GL Driver Message \(OpenGL, Performance/;

export class Browser {
  /** `gl`: false for a browser without WebGL. */
  static async start(executablePath, gl = true) {
    const profile = mkdtempSync(join(tmpdir(), "report-test-"));
    const context = await chromium.launchPersistentContext(profile, {
      executablePath,
      headless: true,
      args: ["--no-sandbox", ...(gl ? kSoftwareGl : ["--disable-3d-apis"])], // CI runs as root, where the sandbox cannot
      viewport: { width: 1280, height: 900 },
      acceptDownloads: true,
    });
    return new Browser(context, profile);
  }

  constructor(context, profile) {
    this.context = context;
    this.profile = profile;
    this.faults = [];
  }

  /** Opens a file in a fresh page. From now on `faults` holds its console errors, exceptions and requests. */
  async open(file, size = { width: 1280, height: 900 }) {
    for (const old of this.context.pages()) await old.close();
    const page = await this.context.newPage();
    const own = pathToFileURL(file).href;
    this.faults = [];
    page.on("console", (m) => {
      if (["error", "warning"].includes(m.type()) && !kOfDriver.test(m.text())) this.faults.push(`console ${m.type()}: ${m.text()}`);
    });
    page.on("pageerror", (error) => this.faults.push(`exception: ${error.stack ?? error.message}`));
    page.on("request", (request) => {
      const url = request.url();
      if (url.split("#")[0] !== own && !/^(data|blob):/.test(url)) this.faults.push(`request: ${url}`);
    });
    await page.route((url) => !["file:", "data:", "blob:"].includes(url.protocol), (route) => route.abort());
    page.setDefaultTimeout(30_000);
    await page.setViewportSize(size);
    await page.goto(own, { waitUntil: "load" });
    return page;
  }

  async close() {
    await this.context.close();
    rmSync(this.profile, { recursive: true, force: true });
  }
}
