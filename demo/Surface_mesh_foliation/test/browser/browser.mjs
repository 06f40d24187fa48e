// Debian's Chromium without a window, and what a user does with the page in it.
import assert from 'node:assert/strict';
import crypto from 'node:crypto';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import puppeteer from 'puppeteer-core';
import { serve } from '../../serve.mjs';

const root = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../../..');
export const sitePath = path.join(root, 'build/page');
export const outputPath = path.join(root, 'build/page_test');
const picturePath = path.join(outputPath, 'pictures');

// the picture is drawn without a graphics card
const WEBGL = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const NO_WEBGL = ['--disable-gpu', '--disable-3d-apis'];

export const DESKTOP = { width: 1280, height: 720 };
export const PHONE = {
  width: 390,
  height: 844,
  isMobile: true,
  hasTouch: true,
  deviceScaleFactor: 2,
};
export const PATIENCE = 60_000; // milliseconds

/** A browser and a server; closed after the tests of a file. */
export async function start({ hasWebgl = true, isIsolated = true } = {}) {
  fs.mkdirSync(picturePath, { recursive: true });
  const server = await serve(sitePath, 0, isIsolated);
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    protocolTimeout: 2 * PATIENCE,
    args: ['--no-sandbox', ...(hasWebgl ? WEBGL : NO_WEBGL)],
  });
  const address = `http://127.0.0.1:${server.address().port}/`;
  return {
    browser,
    address,
    async close() {
      await browser.close();
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

/** A page in a context of its own; every error of it fails the test that looks at `page.faults`. */
export async function open(
  { browser, address },
  { viewport = DESKTOP, fragment = '', theme = 'light' } = {},
) {
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  page.faults = [];
  page.requested = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') page.faults.push(message.text());
  });
  page.on('request', (request) => page.requested.push(request.url()));
  page.setDefaultTimeout(PATIENCE);
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: theme }]);
  await page.setViewport(viewport);
  await page.goto(address + fragment);
  return page;
}

/** Until the graph is there and nothing is computed. */
export async function settled(page) {
  await page.waitForFunction(
    () =>
      document.body.dataset.busy === 'false' &&
      document.getElementById('summary').textContent !== '',
  );
  await drawn(page);
}

export function drawn(page) {
  return page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
  );
}

/** Until nothing is computed, with or without a graph. */
export function idle(page) {
  return page.waitForFunction(() => document.body.dataset.busy === 'false');
}

/** Until the picture is drawn with smooth edges, some time after its last change. */
export async function smooth(page) {
  await drawn(page);
  await new Promise((resolve) => setTimeout(resolve, 400));
  await page.waitForFunction(() => document.getElementById('view').dataset.edges !== 'quick');
  await page.evaluate(() => {
    const gl = document.getElementById('view').getContext('webgl2');
    gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the frame
  });
  await drawn(page);
}

export async function picture(page, name) {
  await smooth(page);
  await page.screenshot({ path: path.join(picturePath, `${name}.png`) });
}

export function text(page, selector) {
  return page.$eval(selector, (found) => found.textContent.trim());
}

export function isShown(page, selector) {
  return page.$eval(selector, (found) => found.checkVisibility());
}

/** What a user can choose, as the address of the page has it. */
export async function chosen(page) {
  const parts = new URLSearchParams(new URL(page.url()).hash.slice(1));
  return {
    mode: parts.get('mode'),
    detail: Number(parts.get('detail')),
    poles: (parts.get('poles') ?? '').split(',').filter(Boolean),
    loops: (parts.get('loops') ?? '').split(';').filter(Boolean),
  };
}

/** Until the address says so. */
export async function untilChosen(page, isRight, what) {
  const end = Date.now() + PATIENCE;
  while (!isRight(await chosen(page))) {
    if (Date.now() > end) assert.fail(`${what}: ${JSON.stringify(await chosen(page))}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  await settled(page);
}

export async function numberOfArcs(page) {
  return (await page.$$('#arcs tbody tr')).length;
}

/** Where a vertex is in the window, or null if it cannot be seen. */
export function placeOf(page, vertex) {
  return page.$eval(
    '#view',
    (canvas, v) => {
      const { x, y, isVisible } = canvas.screenPosition(v);
      const box = canvas.getBoundingClientRect();
      const [left, top] = [box.left + x, box.top + y];
      return isVisible && document.elementFromPoint(left, top) === canvas
        ? { x: left, y: top }
        : null;
    },
    vertex,
  );
}

/** Of these vertices, those that can be clicked on. */
export async function visible(page, vertices) {
  const found = [];
  for (const vertex of vertices) {
    const place = await placeOf(page, vertex);
    if (place) found.push({ vertex, ...place });
  }
  return found;
}

export async function clickVertex(page, vertex) {
  const place = await placeOf(page, vertex);
  assert.ok(place, `vertex ${vertex} cannot be seen`);
  await page.mouse.click(place.x, place.y);
}

/** Draws a loop: clicks on one vertex after another, and turns the shape as far as needed. */
export async function pick(page, vertices, pictureName) {
  const middle = (await page.$eval('#view', (canvas) => canvas.clientWidth)) / 2;
  for (const [i, vertex] of vertices.entries()) {
    let place = null;
    for (let turn = 0; !place && turn < 40; ++turn) {
      place = await placeOf(page, vertex);
      if (place && Math.abs(place.x - middle) < 70) break;
      place = null;
      await page.focus('#view');
      for (let k = 0; k < 4; ++k) await page.keyboard.press('ArrowRight');
      await drawn(page);
    }
    assert.ok(place, `vertex ${vertex} cannot be seen`);
    await page.mouse.click(place.x, place.y);
    await page.waitForFunction(
      (count) => document.getElementById('drawing-text').textContent.startsWith(`${count} picked`),
      {},
      i + 1,
    );
    if (i === 1) assert.match(await text(page, '#drawing-text'), /1 more/);
    if (pictureName && i === vertices.length - 2) await picture(page, pictureName);
  }
}

export function choose(page, tool) {
  return page.click(`[data-tool="${tool}"]`);
}

export function openTab(page, name) {
  return page.click(`#tab-${name}`);
}

/** Opens a file of this content as a user does. */
export async function openFile(page, name, content) {
  const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'page-')), name);
  fs.writeFileSync(file, content);
  const input = await page.$('#file');
  await input.uploadFile(file);
}

/** Drops a file on the picture. */
export function dropFile(page, name, content) {
  return page.evaluate(
    (fileName, fileContent) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([fileContent], fileName));
      const target = document.getElementById('view');
      for (const type of ['dragenter', 'dragover', 'drop'])
        target.dispatchEvent(
          new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }),
        );
    },
    name,
    content,
  );
}

export async function problem(page) {
  await page.waitForSelector('.message.fault');
  return text(page, '.message.fault p');
}

export function setSlider(page, selector, value) {
  return page.$eval(
    selector,
    (slider, v) => {
      slider.value = String(v);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      slider.dispatchEvent(new Event('change', { bubbles: true }));
    },
    value,
  );
}

/** A digest of the picture's pixels, to see whether they change. */
export async function pixels(page) {
  await smooth(page);
  const canvas = await page.$('#view');
  return crypto
    .createHash('sha256')
    .update(await canvas.screenshot())
    .digest('hex');
}

/** What a function of an image finds in a screenshot of the picture. */
export async function inspect(page, find, argument) {
  const canvas = await page.$('#view');
  const png = Buffer.from(await canvas.screenshot()).toString('base64');
  const blank = await page.browserContext().newPage(); // the page itself forbids code from outside
  try {
    return await blank.evaluate(
      async (address, source, given) => {
        const image = new Image();
        image.src = address;
        await image.decode();
        const { width, height } = image;
        const context = new OffscreenCanvas(width, height).getContext('2d');
        context.drawImage(image, 0, 0);
        const pixels = context.getImageData(0, 0, width, height);
        return new Function(`return ${source}`)()(pixels, given);
      },
      `data:image/png;base64,${png}`,
      String(find),
      argument,
    );
  } finally {
    await blank.close();
    await page.bringToFront();
  }
}
