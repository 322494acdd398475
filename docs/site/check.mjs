// Opens the site from disk in a browser without a window: no page writes an error to the console, every equation is
// typeset, nothing is asked of the network, no link to another page or place is dead, and the search finds equation (13).
// Usage: node docs/site/check.mjs [FOLDER FOR SCREENSHOTS]
import { createRequire } from "node:module";
import { existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = resolve(fileURLToPath(import.meta.url), "../../..");
const site = join(root, "target/site");
const { chromium } = createRequire(join(root, "target/site-tools/package.json"))("playwright-core");
const pictures = process.argv[2];

/** Pages of the book, without those of the API, which rustdoc checks. */
function pages(folder = site) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return path === join(site, "api") ? [] : pages(path);
    return entry.name.endsWith(".html") && entry.name !== "404.html" ? [path] : [];
  });
}

const problems = [];
const complain = (place, text) => problems.push(`${place.replace(`${site}/`, "")}: ${text}`);

const profile = mkdtempSync(join(tmpdir(), "site-"));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});
const page = await browser.newPage();
let current = site;
page.on("console", (message) => message.type() === "error" && complain(current, `console: ${message.text()}`));
page.on("pageerror", (error) => complain(current, `error: ${error.message}`));
page.on("request", (request) => /^https?:/.test(request.url()) && complain(current, `asks the network: ${request.url()}`));

async function open(path, fragment = "") {
  current = path;
  await page.goto(pathToFileURL(path).href + fragment);
  await page.waitForLoadState("load");
}

/** What the open page holds that the check needs. */
const look = () => page.evaluate(() => ({
  equations: document.querySelectorAll(".arithmatex").length,
  typeset: document.querySelectorAll(".arithmatex .katex").length,
  raw: (document.querySelector("article")?.innerText.match(/\$`|\\\(|\\begin\{/g) ?? []).length,
  anchors: [...document.querySelectorAll("[id]")].map((element) => element.id),
  links: [...document.querySelectorAll("article a[href]")].map((link) => link.href).filter((href) => href.startsWith("file:")),
  overflow: document.documentElement.scrollWidth - document.documentElement.clientWidth,
}));

const seen = new Map();
let equations = 0;
for (const path of pages()) {
  await open(path);
  const found = await look();
  equations += found.typeset;
  if (found.typeset !== found.equations) complain(path, `${found.equations - found.typeset} equations are not typeset`);
  if (found.raw > 0) complain(path, `${found.raw} pieces of unread mathematics`);
  seen.set(path, found);
}
for (const [path, found] of seen) {
  for (const link of found.links) {
    const url = new URL(link);
    const target = fileURLToPath(pathToFileURL(decodeURIComponent(url.pathname)));
    const place = decodeURIComponent(url.hash.slice(1));
    if (!existsSync(target)) complain(path, `dead link ${link}`);
    else if (place && seen.has(target) && !seen.get(target).anchors.includes(place)) complain(path, `dead place ${link}`);
  }
}
if (equations < 200) complain(site, `only ${equations} equations in the whole book`);

// The search, as a reader uses it.
await open(join(site, "index.html"));
await page.click("label.md-header__button[for=__search]:visible, .md-search__input:visible");
await page.locator(".md-search__input").pressSequentially("(13)");
await page.waitForSelector(".md-search-result__item", { timeout: 20_000 }).catch(() => complain(site, "the search finds nothing for (13)"));
const results = await page.$$eval(".md-search-result__item > a, .md-search-result__item a.md-search-result__link",
  (links) => links.map((link) => link.getAttribute("href")));
if (!results[0]?.includes("theory/normal-tangent")) complain(site, `the search for (13) finds first ${results.slice(0, 3)}`);
if (pictures) {
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, "search.png") });
  for (const [name, path, width] of [["start", "index.html", 1280], ["theory", "docs/theory/normal-tangent.html", 1280],
    ["how-to", "docs/how-to/call-from-c.html", 1280], ["language", "docs/declare.html", 1280],
    ["narrow", "docs/theory/friction.html", 400], ["narrow-start", "index.html", 400]]) {
    await page.setViewportSize({ width, height: 900 });
    await open(join(site, path));
    await page.screenshot({ path: join(pictures, `${name}.png`) });
    if ((await look()).overflow > 0) complain(path, `${(await look()).overflow} pixels wider than ${width}`);
  }
}
await browser.close();
rmSync(profile, { recursive: true, force: true });

for (const problem of problems) console.error(problem);
console.log(`site: ${seen.size} pages, ${equations} equations, ${problems.length} problems`);
process.exit(problems.length > 0 ? 1 : 0);
