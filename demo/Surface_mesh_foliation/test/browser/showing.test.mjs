// What the picture and the panels show, and what can be taken home.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { unzipSync } from 'fflate';
import * as b from './browser.mjs';

let session;
before(async () => {
  session = await b.start();
});
after(() => session.close());

async function openFirst(options) {
  const page = await b.open(session, options);
  await b.settled(page);
  return page;
}

test('each switch changes the picture, and changes it back', async () => {
  const page = await openFirst();
  await b.openTab(page, 'show');
  const layers = await page.$$eval('[data-layer]', (inputs) =>
    inputs.map((input) => input.dataset.layer),
  );
  assert.equal(layers.length, 9);
  for (const layer of layers) {
    const before = await b.pixels(page);
    await page.click(`[data-layer="${layer}"]`);
    await b.idle(page);
    assert.notEqual(await b.pixels(page), before, layer);
    await page.click(`[data-layer="${layer}"]`);
    await b.idle(page);
    assert.equal(await b.pixels(page), before, layer);
  }
  assert.deepEqual(page.faults, []);
});

test('leaves follow their slider', async () => {
  const page = await openFirst();
  await b.openTab(page, 'show');
  await b.setSlider(page, '#spacing', 6);
  await b.idle(page);
  const few = await b.pixels(page);
  assert.ok(await page.$eval('[data-layer="leaves"]', (input) => input.checked));
  await b.setSlider(page, '#spacing', 40);
  await b.idle(page);
  assert.notEqual(await b.pixels(page), few);
  await b.picture(page, '14_leaves');
});

test('colors by symmetry and by modulus have their legends', async () => {
  const page = await openFirst();
  await b.openTab(page, 'show');
  const colors = new Set();
  for (const coloring of ['parts', 'symmetry', 'modulus', 'flux', 'plain']) {
    await page.select('#coloring', coloring);
    colors.add(await b.pixels(page));
  }
  assert.equal(colors.size, 5);
  await page.select('#coloring', 'symmetry');
  await b.openTab(page, 'graph');
  assert.match(await b.text(page, '#legend'), /alike/);
  await b.picture(page, '15_symmetry');
  await b.openTab(page, 'show');
  await page.select('#coloring', 'modulus');
  await b.openTab(page, 'graph');
  assert.match(await b.text(page, '#legend'), /[Mm]odulus/);
});

test('skeleton with radius, and singularities', async () => {
  const page = await openFirst();
  await b.openTab(page, 'show');
  await page.click('[data-layer="radius"]');
  await b.picture(page, '16_radius');
  await page.click('[data-layer="radius"]');
  await page.click('[data-layer="singularities"]');
  await page.click('[data-layer="edgeValues"]');
  await b.picture(page, '17_values_of_edges');
});

test('a part under the pointer, or in the list, is shown with its numbers', async () => {
  const page = await openFirst();
  const arcs = await b.numberOfArcs(page);
  const { width, height } = await page.$eval('#view', (canvas) => ({
    width: canvas.clientWidth,
    height: canvas.clientHeight,
  }));
  await page.mouse.move(width / 2, 50 + height / 2);
  await page.waitForFunction(() => document.getElementById('part-card').checkVisibility());
  const hovered = await b.text(page, '#part-card');
  assert.match(hovered, /Part \d+: \w+.*Area.*Flux/s);
  await page.mouse.move(4, 60);
  await page.waitForFunction(() => !document.getElementById('part-card').checkVisibility());
  const before = await b.pixels(page);
  await page.focus(`#arcs tbody tr:nth-child(${arcs}) button`);
  assert.match(await b.text(page, '#part-card'), new RegExp(`Part ${arcs}:`));
  assert.notEqual(await b.pixels(page), before);
  // a click keeps it
  await page.mouse.click(width / 2, 50 + height / 2);
  await page.mouse.move(4, 60);
  assert.ok(await b.isShown(page, '#part-card'));
  await b.picture(page, '18_part');
});

test('the picture turns and zooms', async () => {
  const page = await openFirst();
  const seen = new Set([await b.pixels(page)]);
  await page.mouse.move(400, 400);
  await page.mouse.down();
  await page.mouse.move(500, 420, { steps: 5 });
  await page.mouse.up();
  seen.add(await b.pixels(page));
  await page.mouse.wheel({ deltaY: -300 });
  seen.add(await b.pixels(page));
  await page.focus('#view');
  await page.keyboard.press('ArrowUp');
  seen.add(await b.pixels(page));
  await page.keyboard.press('-');
  seen.add(await b.pixels(page));
  assert.equal(seen.size, 5);
  await page.click('#fit');
  await page.setViewport({ width: 1000, height: 600 });
  await b.drawn(page);
  const size = await page.$eval('#view', (canvas) => [
    canvas.clientWidth,
    canvas.parentElement.clientWidth,
  ]);
  assert.equal(size[0], size[1]);
});

/** Of the pixels where a row of an image comes from the background to the shape, or leaves it: the
 *  share of those that are a mixture of both. The lowest part of the picture has no buttons. */
function softness({ width, height, data }) {
  const row = (height - 30) * width;
  const [r, g, b] = data.subarray(4 * row);
  const isGround = (i) => data[4 * i] === r && data[4 * i + 1] === g && data[4 * i + 2] === b;
  const distance = (i, j) =>
    Math.hypot(...[0, 1, 2].map((k) => data[4 * i + k] - data[4 * j + k]));
  let soft = 0;
  let all = 0;
  for (let y = height >> 1; y < height - 30; ++y)
    for (let i = y * width + 2; i < (y + 1) * width - 2; ++i)
      for (const step of [-1, 1]) {
        if (isGround(i) || !isGround(i + step) || isGround(i - step)) continue;
        ++all;
        if (distance(i, i - step) > 30) ++soft;
      }
  return { share: soft / all, all };
}

test('edges become smooth when nothing moves, and the canvas keeps its size', async () => {
  const page = await openFirst();
  const size = () => page.$eval('#view', ({ width, height }) => [width, height]);
  await b.smooth(page);
  const atRest = await b.inspect(page, softness);
  const sizeAtRest = await size();
  await page.evaluate(() => {
    const turn = () =>
      document
        .getElementById('view')
        .dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true }));
    window.turning = setInterval(turn, 30);
  });
  await b.drawn(page);
  const moving = await b.inspect(page, softness);
  assert.deepEqual(await size(), sizeAtRest);
  await page.evaluate(() => clearInterval(window.turning));
  await b.smooth(page);
  const again = await b.inspect(page, softness);
  assert.deepEqual(await size(), sizeAtRest);
  for (const { all } of [atRest, moving, again]) assert.ok(all > 100, `${all} pixels`);
  const shares = [atRest, moving, again].map(({ share }) => share);
  assert.ok(shares[0] > 0.3 && shares[2] > 0.3 && shares[1] < 0.1, shares.join());
});

test('who zooms into the shape sees its walls', async () => {
  const page = await openFirst();
  const cornerOf = ({ width, data }) => [...data.subarray(4 * (width - 1), 4 * width - 1)];
  const shareOf = ({ data }, color) => {
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if (color.every((value, k) => data[i + k] === value)) ++count;
    return (4 * count) / data.length;
  };
  await b.smooth(page);
  const ground = await b.inspect(page, cornerOf);
  assert.ok((await b.inspect(page, shareOf, ground)) > 0.5);
  await page.focus('#view');
  for (let i = 0; i < 60; ++i) await page.keyboard.press('+');
  await b.smooth(page);
  const shown = await b.inspect(page, shareOf, ground);
  await b.picture(page, '23_inside');
  assert.ok(shown < 0.1, `${shown} of the picture are background`);
});

test('dark and light follow the system, and the switch', async () => {
  const page = await openFirst({ theme: 'dark' });
  const theme = () => page.$eval(':root', (root) => root.dataset.theme);
  assert.equal(await theme(), 'dark');
  await b.picture(page, '19_dark');
  await page.click('#theme');
  assert.equal(await theme(), 'light');
  await page.reload();
  await b.settled(page);
  assert.equal(await theme(), 'light');
});

test('all files and the picture can be taken home', async () => {
  const page = await openFirst();
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'page-'));
  const client = await page.createCDPSession();
  await client.send('Browser.setDownloadBehavior', {
    behavior: 'allow',
    downloadPath: folder,
    browserContextId: page.browserContext().id,
  });
  await page.click('#save');
  await b.picture(page, '20_download');
  const names = await page.$$eval('#files button', (buttons) =>
    buttons.map((button) => button.textContent),
  );
  assert.ok(names.length >= 17);
  const arrived = async (name) => {
    const file = path.join(folder, name);
    for (let i = 0; i < 500; ++i) {
      if (fs.existsSync(file) && fs.statSync(file).size > 0) return fs.readFileSync(file);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    return assert.fail(`${name} did not arrive`);
  };
  for (const name of ['picture.png', 'reeb_graph.graphml', 'segments.ply']) {
    await page.evaluate((wanted) => {
      [...document.querySelectorAll('#files button')].find((x) => x.textContent === wanted).click();
    }, name);
    await arrived(name);
  }
  assert.match((await arrived('reeb_graph.graphml')).toString(), /<graphml/);
  const png = await arrived('picture.png');
  assert.equal(png.subarray(1, 4).toString(), 'PNG');
  const canvas = await page.$eval('#view', ({ clientWidth, clientHeight, width }) => ({
    clientWidth,
    clientHeight,
    width,
  }));
  assert.equal(png.readUInt32BE(16), 2 * canvas.clientWidth);
  assert.equal(png.readUInt32BE(20), 2 * canvas.clientHeight);
  assert.equal(canvas.width, canvas.clientWidth); // the canvas is as it was
  await page.click('#save-all');
  const files = unzipSync(new Uint8Array(await arrived('homer.zip')));
  assert.deepEqual(Object.keys(files).sort(), [...names].sort());
  for (const [name, bytes] of Object.entries(files)) assert.ok(bytes.length > 20, name);
  const arcs = await b.numberOfArcs(page);
  assert.equal(
    JSON.parse(Buffer.from(files['reeb_graph.json'])).reeb_graph?.arcs.length ?? arcs,
    arcs,
  );
  assert.deepEqual(page.faults, []);
});
