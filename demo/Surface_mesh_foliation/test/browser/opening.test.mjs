// A mesh comes to the page: examples, files of all formats, drops, repair, links; and what goes
// wrong.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import * as b from './browser.mjs';
import { body, damaged, toObj, toOff, toPly, toStl, torus } from './meshes.mjs';

let session;
before(async () => {
  session = await b.start();
});
after(() => session.close());

test('the first example has its graph at once, and nothing is fetched from elsewhere', async () => {
  const page = await b.open(session);
  await b.settled(page);
  assert.ok((await b.numberOfArcs(page)) >= 4);
  assert.match(await b.text(page, '#summary'), /certified/);
  assert.match(await b.text(page, '#privacy'), /No mesh leaves it/);
  for (const url of page.requested)
    assert.ok(url.startsWith(session.address) || url.startsWith('data:'), url);
  assert.deepEqual(page.faults, []);
  await b.picture(page, '01_homer');
});

test('an example with handles has cycles', async () => {
  const page = await b.open(session);
  await b.settled(page);
  await page.select('#examples', 'elephant');
  await page.waitForFunction(() =>
    document.getElementById('numbers').textContent.includes('elephant'),
  );
  await b.settled(page);
  assert.match(await b.text(page, '#summary'), /3 cycles/);
  await b.picture(page, '02_elephant');
});

test('files of all formats are read, whether chosen or dropped', async () => {
  const page = await b.open(session);
  await b.settled(page);
  const mesh = torus(24, 12);
  const files = { off: toOff(mesh), obj: toObj(mesh), ply: toPly(mesh), stl: toStl(mesh) };
  for (const [format, content] of Object.entries(files)) {
    await b.openFile(page, `torus_${format}.${format}`, content);
    await page.waitForFunction(
      (name) => document.getElementById('numbers').textContent.includes(name),
      {},
      `torus_${format}`,
    );
    await b.settled(page);
    const numbers = await b.text(page, '#numbers');
    assert.match(numbers, /Vertices288/);
    assert.match(numbers, /Genus1/);
    assert.equal((await b.numberOfArcs(page)) >= 1, true);
  }
  await b.dropFile(page, 'dropped.off', files.off);
  await page.waitForFunction(() =>
    document.getElementById('numbers').textContent.includes('dropped'),
  );
  await b.settled(page);
  assert.equal(await b.isShown(page, '#drop'), false);
  assert.deepEqual(page.faults, []);
});

test('a damaged mesh is refused, then repaired with a report', async () => {
  const page = await b.open(session);
  await b.settled(page);
  const arcs = await b.numberOfArcs(page);
  await b.openFile(page, 'damaged.off', toOff(damaged(torus(24, 12))));
  await b.problem(page);
  assert.equal(await b.numberOfArcs(page), arcs); // what was shown is still there
  await b.picture(page, '03_damaged_mesh');
  await page.click('.message.fault p + button');
  await page.waitForFunction(() =>
    document.getElementById('numbers').textContent.includes('damaged'),
  );
  await b.settled(page);
  await b.openTab(page, 'mesh');
  assert.ok((await page.$$('#report li')).length >= 1);
  await b.picture(page, '04_repaired_mesh');
});

test('a bad file says what is wrong with it, and what is shown stays', async () => {
  const page = await b.open(session);
  await b.settled(page);
  const before = await b.chosen(page);
  await b.openFile(page, 'bad.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\nx y z\n3 0 1 2\n');
  assert.match(await b.problem(page), /line|bad\.off/);
  await page.click('.message.fault button[aria-label="Close"]');
  await b.openFile(page, 'notes.txt', 'hello');
  assert.match(await b.problem(page), /OFF, OBJ, PLY and STL/);
  assert.deepEqual(await b.chosen(page), before);
  // and the mesh that is shown can still be edited
  await page.click('input[value="star"]');
  await b.untilChosen(page, ({ mode }) => mode === 'star', 'star');
});

test('a huge mesh is refused politely', async () => {
  const page = await b.open(session);
  await b.settled(page);
  await b.openFile(page, 'scan.off', 'OFF\n1000000 1999996 0\n' + '0 0 0\n'.repeat(1000));
  assert.match(await b.problem(page), /1,000,000 vertices.*Simplify/);
  await b.picture(page, '05_huge_mesh');
});

test('a link brings the state back', async () => {
  const page = await b.open(session);
  await b.settled(page);
  await page.click('input[value="all"]');
  await b.untilChosen(page, ({ mode }) => mode === 'all', 'all');
  await page.click('#share');
  const link = await page.$eval('#share-link', (input) => input.value);
  await b.picture(page, '06_share');
  const other = await b.open(session, { fragment: new URL(link).hash });
  await b.settled(other);
  assert.deepEqual(await b.chosen(other), await b.chosen(page));
  assert.equal(await b.text(other, '#arcs tbody'), await b.text(page, '#arcs tbody'));
  assert.deepEqual(other.faults, []);
  // and with loops that were found, and stay as they are
  await other.click('input[value="given"]');
  await b.untilChosen(other, ({ mode, loops }) => mode === 'given' && loops.length === 2, 'given');
  const third = await b.open(session, { fragment: new URL(other.url()).hash });
  await b.settled(third);
  assert.deepEqual(await b.chosen(third), await b.chosen(other));
  assert.equal(await b.numberOfArcs(third), await b.numberOfArcs(other));
});

test('a link of a file asks for the file, and is applied to it', async () => {
  const fragment = '#file=body.off&size=962,1920&mode=star&poles=0,961,30*0.5';
  const page = await b.open(session, { fragment });
  assert.match(await b.problem(page), /body\.off/);
  await b.openFile(page, 'body.off', toOff(body(30, 32)));
  await b.settled(page);
  assert.deepEqual((await b.chosen(page)).poles, ['0', '961', '30*0.5']);
  assert.equal(await b.numberOfArcs(page), 3);
});

test('a damaged link is ignored, and the page says so', async () => {
  const page = await b.open(session, { fragment: '#example=homer&poles=1,x' });
  await page.waitForSelector('.message');
  assert.match(await b.text(page, '.message'), /damaged/);
  await b.settled(page);
});
