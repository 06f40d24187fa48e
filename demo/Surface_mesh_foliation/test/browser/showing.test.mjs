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
  assert.equal((await arrived('picture.png')).subarray(1, 4).toString(), 'PNG');
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
