// Bundles src/ into template.html, one file that needs nothing else. The same sources and lock file give the same bytes:
// node build.mjs [OUTPUT]
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry) {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["chrome111", "firefox113", "safari16.4"],
    charset: "ascii",
    legalComments: "inline",
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

// Within a script or style element the text must not end it.
function inside(text, tag) {
  return text.replaceAll(`</${tag}`, `<\\/${tag}`).replaceAll("<!--", "<\\!--").trimEnd();
}

function notices() {
  const packages = ["plotly.js-cartesian-dist-min", "three"];
  const texts = packages.map((name) => {
    const { version } = JSON.parse(readFileSync(join(here, "node_modules", name, "package.json"), "utf8"));
    const license = readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim();
    return `${name} ${version}\n\n${license}`;
  });
  return `This page contains:\n\n${texts.join("\n\n")}`;
}

const parts = {
  STYLE: inside(await bundle("src/style.css"), "style"),
  SCRIPT: inside(await bundle("src/main.ts"), "script"),
  NOTICES: notices().replaceAll("--", "- -"),
};
const page = readFileSync(join(here, "src/page.html"), "utf8").replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
writeFileSync(process.argv[2] ?? join(here, "template.html"), page);
