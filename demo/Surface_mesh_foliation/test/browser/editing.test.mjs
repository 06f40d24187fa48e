// Poles, loops, heights and modes, by mouse, finger and keyboard; undo and redo; refusals.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import * as b from './browser.mjs';
import { body, toOff } from './meshes.mjs';

const RINGS = 60;
const SECTORS = 48;

let session;
before(async () => {
  session = await b.start();
});
after(() => session.close());

async function openBody(options = {}) {
  const page = await b.open(session, options);
  await b.settled(page);
  await b.openFile(page, 'body.off', toOff(body(RINGS, SECTORS)));
  await page.waitForFunction(() =>
    document.getElementById('numbers').textContent.includes('body.off'),
  );
  await b.settled(page);
  return page;
}

/** Vertices of the belly, from left to right: away from poles, and not at the edge of the shape. */
async function belly(page) {
  const vertices = Array.from({ length: SECTORS }, (_, j) => 1 + 34 * SECTORS + j);
  const found = await b.visible(page, vertices);
  const inside = found.sort((p, q) => p.x - q.x).slice(4, -4);
  assert.ok(inside.length > 6, 'the belly can be seen');
  return inside;
}

test('poles are found at the ends of the limbs', async () => {
  const page = await openBody();
  assert.equal((await b.chosen(page)).poles.length, 5);
});

test('a click adds a pole, a drag moves it, a key removes it; undo and redo', async () => {
  const page = await openBody();
  const places = await belly(page);
  const before = await b.chosen(page);
  const arcs = await b.numberOfArcs(page);
  await b.choose(page, 'poles');
  await page.mouse.click(places[2].x, places[2].y);
  await b.untilChosen(page, ({ poles }) => poles.length === before.poles.length + 1, 'a pole more');
  assert.ok((await b.chosen(page)).poles.includes(String(places[2].vertex)));
  assert.ok((await b.numberOfArcs(page)) > arcs);
  await b.picture(page, '07_added_pole');

  const goal = places[places.length - 3];
  await page.mouse.move(places[2].x, places[2].y);
  await page.mouse.down();
  await page.mouse.move((places[2].x + goal.x) / 2, (places[2].y + goal.y) / 2, { steps: 4 });
  await page.mouse.move(goal.x, goal.y, { steps: 4 });
  await page.mouse.up();
  await b.untilChosen(page, ({ poles }) => poles.includes(String(goal.vertex)), 'a moved pole');
  assert.equal((await b.chosen(page)).poles.length, before.poles.length + 1);

  await page.focus('#view');
  await page.keyboard.press('Delete');
  await b.untilChosen(page, ({ poles }) => poles.length === before.poles.length, 'a pole less');

  await page.click('#undo');
  await b.untilChosen(
    page,
    ({ poles }) => poles.includes(String(goal.vertex)),
    'undo of the removal',
  );
  await page.keyboard.down('Control');
  await page.keyboard.press('z');
  await page.keyboard.up('Control');
  await b.untilChosen(
    page,
    ({ poles }) => poles.includes(String(places[2].vertex)),
    'undo of the move',
  );
  await page.click('#undo');
  await b.untilChosen(
    page,
    ({ poles }) => poles.length === before.poles.length,
    'undo of the click',
  );
  assert.ok(await page.$eval('#undo', (button) => button.disabled));
  await page.click('#redo');
  await b.untilChosen(page, ({ poles }) => poles.includes(String(places[2].vertex)), 'redo');
  assert.deepEqual(page.faults, []);
});

test('too few poles are refused, and the last pole stays', async () => {
  const page = await openBody();
  await page.click('input[value="star"]');
  await b.untilChosen(page, ({ mode }) => mode === 'star', 'star');
  await b.openTab(page, 'edit');
  let count = (await b.chosen(page)).poles.length;
  let message = null;
  while (!message && count > 0) {
    await page.click('#poles li:last-child button[aria-label^="Remove"]');
    await b.idle(page);
    message = await page.$eval('.message.fault p', (p) => p.textContent).catch(() => null);
    if (!message)
      await b.untilChosen(page, ({ poles }) => poles.length === count - 1, 'a pole less');
    if (!message) --count;
  }
  assert.ok(message, 'the page says why');
  assert.equal((await page.$$('#poles .name')).length, count);
  assert.ok(count >= 1);
  await b.picture(page, '08_too_few_poles');
});

test('the height of a pole is set by its slider', async () => {
  const page = await openBody();
  await b.openTab(page, 'edit');
  await b.setSlider(page, '#poles li:first-child input', Math.log10(2));
  await b.untilChosen(page, ({ poles }) => poles[0].endsWith('*2'), 'a height');
  assert.equal(await b.text(page, '#poles li:first-child output'), '2');
  await page.click('#undo');
  await b.untilChosen(page, ({ poles }) => !poles[0].includes('*'), 'the height before');
  assert.equal(await b.text(page, '#poles li:first-child output'), '1');
});

test('star, canonical and all have more and more arcs', async () => {
  const page = await openBody();
  const arcs = {};
  for (const mode of ['star', 'canonical', 'all']) {
    await page.click(`input[value="${mode}"]`);
    await b.untilChosen(page, (state) => state.mode === mode, mode);
    arcs[mode] = await b.numberOfArcs(page);
  }
  assert.equal(arcs.star, 5);
  assert.ok(arcs.star <= arcs.canonical && arcs.canonical <= arcs.all);
  assert.equal(arcs.all, 7); // five ends, and two loops until no node has more than three arcs
});

test('the detail slider goes through the hierarchy', async () => {
  const page = await openBody();
  await page.waitForFunction(() => !document.getElementById('detail').disabled);
  const most = Number(await page.$eval('#detail', (slider) => slider.max));
  assert.ok(most >= 1);
  const arcs = [];
  for (let step = 0; step <= most; ++step) {
    await b.setSlider(page, '#detail', step);
    await page.waitForFunction(
      (kept) => document.querySelectorAll('#arcs tbody tr').length === kept,
      {},
      5 + Number((await b.text(page, '#detail-text')).split(' ')[0]),
    );
    await b.settled(page);
    arcs.push(await b.numberOfArcs(page));
  }
  assert.equal(arcs[0], 5);
  assert.equal(arcs[most], 7);
  await b.picture(page, '09_all_details');
});

test('levels near the slider are there at once', async () => {
  const page = await openBody();
  await page.waitForFunction(() => !document.getElementById('detail').disabled);
  await page.hover('#detail');
  await page.waitForFunction(() => document.getElementById('detail').dataset.ahead === 'solved');
  const most = Number(await page.$eval('#detail', (slider) => slider.max));
  await b.setSlider(page, '#detail', most);
  assert.equal(await b.numberOfArcs(page), 7); // without waiting
});

test('a loop is drawn vertex by vertex, is checked, and can be removed', async () => {
  const page = await openBody();
  await page.click('input[value="star"]');
  await b.untilChosen(page, ({ mode }) => mode === 'star', 'star');
  await b.choose(page, 'loop');
  // around the waist, between arms and legs; the shape is turned as far as needed
  const ring = 34;
  const wanted = [0, 8, 16, 24, 32, 40].map((j) => 1 + ring * SECTORS + j);
  await b.pick(page, wanted, '10_drawing_a_loop');
  await page.waitForFunction(() => !document.getElementById('drawing-finish').disabled);
  await page.focus('#view');
  await page.keyboard.press('Enter');
  await b.untilChosen(page, ({ mode, loops }) => mode === 'given' && loops.length === 1, 'a loop');
  assert.equal(await b.numberOfArcs(page), 6);
  await b.openTab(page, 'edit');
  assert.match(await b.text(page, '#loops'), /Loop 1, drawn/);
  await b.setSlider(page, '#loops input', Math.log10(2));
  await b.untilChosen(page, ({ loops }) => loops[0].endsWith('*2'), 'the height of a loop');
  await page.click('#loops button[aria-label^="Remove"]');
  await b.untilChosen(page, ({ loops }) => loops.length === 0, 'no loop');
  assert.equal(await b.numberOfArcs(page), 5);
  assert.deepEqual(page.faults, []);
});

test('a loop that crosses another one is refused while it is drawn', async () => {
  const at = (ring, sector) => 1 + ring * SECTORS + sector;
  const waist = [0, 8, 16, 24, 32, 40].map((sector) => at(34, sector));
  const steps = waist.map((vertex, i) => (vertex - (waist[i - 1] ?? 0)).toString(36)).join('.');
  const ends = [0, at(24, 2), at(24, 22), at(51, 0), at(51, 24)];
  const size = `${2 + RINGS * SECTORS},${2 * RINGS * SECTORS}`;
  const fragment = `#file=body.off&size=${size}&mode=given&poles=${ends}&loops=${steps}`;
  const page = await b.open(session, { fragment });
  await b.openFile(page, 'body.off', toOff(body(RINGS, SECTORS)));
  await b.settled(page);
  assert.equal((await b.chosen(page)).loops.length, 1);
  await b.choose(page, 'loop');
  // down at the front, up at the back, and between the head and an arm: across the waist twice
  await b.pick(page, [at(30, 36), at(50, 36), at(50, 12), at(30, 12), at(12, 2)]);
  await page.waitForSelector('#drawing-text.fault');
  assert.match(await b.text(page, '#drawing-text'), /loop 1/);
  assert.ok(await page.$eval('#drawing-finish', (button) => button.disabled));
  await b.picture(page, '11_crossing_loop');
});

test('a loop that bounds a disk is refused while it is drawn', async () => {
  const page = await openBody();
  await b.choose(page, 'loop');
  const places = await belly(page);
  const near = [places[3].vertex, places[4].vertex, places[4].vertex + SECTORS];
  for (const [i, vertex] of near.entries()) {
    await b.clickVertex(page, vertex);
    if (i < 2)
      await page.waitForFunction(
        (count) =>
          document.getElementById('drawing-text').textContent.startsWith(`${count} picked`),
        {},
        i + 1,
      );
  }
  await page.waitForFunction(() =>
    document.getElementById('drawing-text').textContent.includes('disk'),
  );
  assert.ok(await page.$eval('#drawing-finish', (button) => button.disabled));
  await b.picture(page, '11_refused_loop');
  await page.focus('#view');
  await page.keyboard.press('Backspace');
  await page.waitForFunction(() =>
    document.getElementById('drawing-text').textContent.startsWith('2 picked'),
  );
  await page.keyboard.press('Escape');
  assert.equal(await b.isShown(page, '#drawing'), false);
});

test('without a mouse: the shape is turned, a pole added, moved and removed', async () => {
  const page = await openBody();
  const { poles } = await b.chosen(page);
  await page.focus('body');
  await page.keyboard.press('p');
  assert.equal(
    await page.$eval('[data-tool="poles"]', (button) => button.getAttribute('aria-checked')),
    'true',
  );
  await page.focus('#tools button[aria-checked="true"]');
  await page.keyboard.down('Shift');
  await page.keyboard.press('Tab');
  await page.keyboard.up('Shift');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'view');
  assert.ok(await b.isShown(page, '#crosshair'));
  await page.keyboard.press(' ');
  await b.untilChosen(page, (state) => state.poles.length === poles.length + 1, 'a pole more');
  await b.picture(page, '12_keyboard');
  const added = (await b.chosen(page)).poles.at(-1);
  for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('m');
  await b.untilChosen(page, (state) => state.poles.at(-1) !== added, 'a moved pole');
  await page.keyboard.press('Delete');
  await b.untilChosen(page, (state) => state.poles.length === poles.length, 'a pole less');
});

test('with fingers: a tap adds a pole', async () => {
  const page = await openBody({ viewport: b.PHONE });
  const { poles } = await b.chosen(page);
  const places = await belly(page);
  await page.tap('[data-tool="poles"]');
  await page.touchscreen.tap(places[4].x, places[4].y);
  await b.untilChosen(page, (state) => state.poles.length === poles.length + 1, 'a pole more');
  await b.picture(page, '13_phone');
});
