// How long things take in the browser, written as a table; and the page while the engine is busy.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import zlib from 'node:zlib';
import * as b from './browser.mjs';
import { body, toOff } from './meshes.mjs';

const MOST_TO_DOWNLOAD = 1.5e6; // bytes, compressed
const rows = [];

let session;
before(async () => {
  session = await b.start();
});
after(async () => {
  await session.close();
  const lines = rows.map(([mesh, vertices, what, time]) => [mesh, vertices, what, Math.round(time)].join());
  const table = [...notes(), 'mesh,vertices,what,milliseconds', ...lines].join('\n');
  fs.writeFileSync(path.join(b.outputPath, 'page.csv'), table + '\n');
  console.log(table);
});

/** The manual's table is a copy of this file. */
function notes() {
  const date = new Date().toISOString().slice(0, 10);
  return [
    `# ${os.cpus()[0].model}, ${os.cpus().length} cores, Chromium without a graphics card, ${date}.`,
    '# Medians. Made by: demo/Surface_mesh_foliation/test.sh',
  ];
}

async function openBody(page, rings, sectors) {
  const name = `body_${2 + rings * sectors}.off`;
  await b.openFile(page, name, toOff(body(rings, sectors)));
  await page.waitForFunction(
    (n) => document.getElementById('numbers').textContent.includes(n),
    {},
    name,
  );
}

/** From a click on a vertex until the picture shows the parts with the new pole, as a sketch of the
 *  result; until the result is there, and until the picture shows that. */
async function timeOfClick(page, vertex) {
  const { x, y } = await b.placeOf(page, vertex);
  await b.smooth(page);
  await page.evaluate(() => {
    document.body.dataset.drawn = '';
    document.body.dataset.sketched = '';
    addEventListener('pointerup', () => (window.clickedAt = performance.now()), {
      once: true,
      capture: true,
    });
  });
  await page.mouse.click(x, y, { delay: 80 }); // about as long as a person presses
  await page.waitForFunction(() => document.body.dataset.drawn !== '', { polling: 5 });
  const times = await page.evaluate(() => ({
    sketched: Number(document.body.dataset.sketched) - window.clickedAt,
    drawn: Number(document.body.dataset.drawn) - window.clickedAt,
    ...JSON.parse(document.body.dataset.timing),
  }));
  await b.settled(page);
  return times;
}

/** Vertices that can be seen and are not at the edge of the shape. */
async function innerVertices(page, numberOfVertices) {
  const every = Math.ceil(numberOfVertices / 150);
  const sample = Array.from({ length: 150 }, (_, i) => every * i).filter(
    (v) => v < numberOfVertices,
  );
  const seen = await b.visible(page, sample);
  const sum = seen.reduce(({ x, y }, place) => ({ x: x + place.x, y: y + place.y }), {
    x: 0,
    y: 0,
  });
  const distance = ({ x, y }) => Math.hypot(x - sum.x / seen.length, y - sum.y / seen.length);
  return seen.sort((p, q) => distance(p) - distance(q)).map(({ vertex }) => vertex);
}

// a human body, if there is one, is the mesh that the native program is measured with
const shared = process.env.SURFACE_MESH_FOLIATION_SHARED_DIR;
const human = shared ? path.join(shared, 'meshes/human_man_6890.off') : '';

test('a click at 6,890 vertices', async () => {
  const page = await b.open(session);
  await b.settled(page);
  const [mesh, content] = fs.existsSync(human)
    ? ['human', fs.readFileSync(human)]
    : ['body', toOff(body(82, 84))];
  const name = `${mesh}.off`;
  await b.openFile(page, name, content);
  await page.waitForFunction(
    (n) => document.getElementById('numbers').textContent.includes(n),
    {},
    name,
  );
  await b.settled(page);
  const { untilResult } = await page.evaluate(() => JSON.parse(document.body.dataset.timing));
  rows.push([mesh, 6890, 'first result after loading', untilResult]);
  assert.ok(untilResult < 3000);
  await b.choose(page, 'poles');
  const vertices = (await innerVertices(page, 6890)).slice(0, 7);
  assert.equal(vertices.length, 7);
  for (const mode of ['star', 'canonical']) {
    await b.openTab(page, 'graph');
    await page.click(`input[value="${mode}"]`);
    await b.settled(page);
    const times = [];
    for (const vertex of vertices) {
      times.push(await timeOfClick(page, vertex));
      await page.click('#undo');
      await b.settled(page);
    }
    const median = (key) => times.map((t) => t[key]).sort((p, q) => p - q)[times.length >> 1];
    rows.push([mesh, 6890, `${mode}: click to picture with the parts`, median('sketched')]);
    rows.push([mesh, 6890, `${mode}: click to result`, median('untilResult')]);
    rows.push([mesh, 6890, `${mode}: of it in the engine`, median('inEngine')]);
    rows.push([mesh, 6890, `${mode}: click to picture of the result`, median('drawn')]);
    assert.ok(median('untilResult') < 1000);
    assert.ok(median('sketched') > 0 && median('sketched') < median('drawn'));
  }
});

test('110,000 vertices work, the page stays alive, newer edits win', async () => {
  const page = await b.open(session);
  await b.settled(page);
  const began = Date.now();
  await openBody(page, 331, 332); // 109,894 vertices
  await b.picture(page, '22_busy');
  await b.settled(page);
  rows.push(['body', 109894, 'file to canonical graph', Date.now() - began]);
  const before = await b.chosen(page);

  // edits one after another: the last one wins
  await page.click('input[value="all"]');
  await page.click('input[value="star"]');
  await b.untilChosen(page, ({ mode }) => mode === 'star', 'star');
  assert.equal(await b.numberOfArcs(page), before.poles.length);

  // a height, which needs a new solution; meanwhile the page answers
  await b.openTab(page, 'edit');
  const start = Date.now();
  await b.setSlider(page, '#poles li:first-child input', Math.log10(3));
  const longest = await page.evaluate(
    () =>
      new Promise((resolve) => {
        let last = performance.now();
        let worst = 0;
        const tick = setInterval(() => {
          worst = Math.max(worst, performance.now() - last);
          last = performance.now();
          if (document.body.dataset.busy === 'false') {
            clearInterval(tick);
            resolve(worst);
          }
        }, 5);
      }),
  );
  rows.push(['body', 109894, 'a height', Date.now() - start]);
  rows.push(['body', 109894, 'longest time without answer meanwhile', longest]);
  assert.ok(longest < 1000, `the page slept for ${longest} ms`);
});

test('a computation can be canceled, and what was shown stays', async () => {
  const page = await b.open(session);
  await b.settled(page);
  await openBody(page, 331, 332);
  await b.settled(page);
  const before = await b.chosen(page);
  await b.openTab(page, 'edit');
  const places = await b.visible(page, [
    1 + 180 * 332 + 250,
    1 + 180 * 332 + 240,
    1 + 180 * 332 + 260,
    1 + 180 * 332 + 230,
  ]);
  assert.ok(places.length > 0);
  await b.choose(page, 'poles');
  await page.mouse.click(places[0].x, places[0].y);
  // the button is used as soon as it is there: a fast machine may be done soon after
  await page.waitForFunction(() => {
    const button = document.getElementById('cancel');
    if (button.checkVisibility()) button.click();
    return button.checkVisibility() || document.getElementById('messages').textContent !== '';
  });
  assert.match(await b.text(page, '#messages'), /Canceled/);
  await b.settled(page);
  assert.deepEqual((await page.$$('#poles .name')).length, before.poles.length);
  // and work goes on
  await b.openTab(page, 'graph');
  await page.click('input[value="star"]');
  await b.untilChosen(page, ({ mode }) => mode === 'star', 'star');
  assert.equal(await b.numberOfArcs(page), before.poles.length);
});

test('where memory cannot be shared, all the same', async () => {
  const plain = await b.start({ isIsolated: false });
  try {
    const page = await b.open(plain);
    await b.settled(page);
    assert.equal(await page.evaluate(() => crossOriginIsolated), false);
    await page.click('input[value="all"]');
    await b.untilChosen(page, ({ mode }) => mode === 'all', 'all');
    assert.deepEqual(page.faults, []);
  } finally {
    await plain.close();
  }
});

test('what a visitor downloads', () => {
  const names = [
    'index.html',
    'page.css',
    'page.js',
    'worker.js',
    'engine.wasm',
    'examples/homer.off',
  ];
  const sizes = names.map(
    (name) => zlib.gzipSync(fs.readFileSync(path.join(b.sitePath, name))).length,
  );
  const total = sizes.reduce((sum, size) => sum + size, 0);
  console.log(`downloads: ${total} bytes compressed`);
  assert.ok(total < MOST_TO_DOWNLOAD, `${total} bytes`);
});
