// The page for everybody: checks of accessibility, nothing overlaps, no WebGL.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import * as b from './browser.mjs';

const axe = fs.readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

let session;
before(async () => {
  session = await b.start();
});
after(() => session.close());

async function violations(page) {
  await page.evaluate(axe);
  const { violations: found } = await page.evaluate(() =>
    axe.run(document, { resultTypes: ['violations'] }),
  );
  return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' | ')}`);
}

/** Pairs of visible things beside and over the picture, and rows of the page, that overlap or
 *  stick out. */
function misplaced(page) {
  return page.evaluate(() => {
    const selectors = [
      'header > *',
      '#tools',
      '#fit',
      '#hint',
      '#drawing',
      '#part-card',
      '#busy',
      '.message',
    ];
    const things = selectors
      .flatMap((selector) => [...document.querySelectorAll(selector)])
      .filter((thing) => thing.checkVisibility() && thing.getClientRects().length > 0)
      .map((thing) => ({
        name: thing.id || thing.className || thing.tagName,
        box: thing.getBoundingClientRect(),
      }))
      .filter(({ box }) => box.width > 2 && box.height > 2);
    const found = [];
    for (const { name, box } of things)
      if (
        box.left < 0 ||
        box.top < 0 ||
        box.right > innerWidth + 0.5 ||
        box.bottom > innerHeight + 0.5
      )
        found.push(`${name} sticks out`);
    things.forEach((a, i) =>
      things.slice(i + 1).forEach((c) => {
        const isApart =
          a.box.right <= c.box.left + 0.5 ||
          c.box.right <= a.box.left + 0.5 ||
          a.box.bottom <= c.box.top + 0.5 ||
          c.box.bottom <= a.box.top + 0.5;
        if (!isApart) found.push(`${a.name} overlaps ${c.name}`);
      }),
    );
    if (document.documentElement.scrollWidth > innerWidth) found.push('the page scrolls sideways');
    if (document.documentElement.scrollHeight > innerHeight) found.push('the page scrolls');
    for (const panel of document.querySelectorAll('[role=tabpanel]'))
      if (panel.checkVisibility() && panel.scrollWidth > panel.clientWidth)
        found.push(`${panel.id} scrolls sideways`);
    return found;
  });
}

for (const [name, viewport] of Object.entries({ desktop: b.DESKTOP, phone: b.PHONE }))
  for (const theme of ['light', 'dark'])
    test(`all panels and dialogs are accessible and apart: ${name}, ${theme}`, async () => {
      const page = await b.open(session, { viewport, theme });
      await b.settled(page);
      for (const tab of ['graph', 'show', 'edit', 'mesh']) {
        await b.openTab(page, tab);
        assert.deepEqual(await violations(page), [], tab);
        assert.deepEqual(await misplaced(page), [], tab);
        if (theme === 'light') await b.picture(page, `${name}_${tab}`);
      }
      for (const [button, dialog] of [
        ['save', 'save-dialog'],
        ['share', 'share-dialog'],
        ['help', 'help-dialog'],
      ]) {
        await page.click(`#${button}`);
        assert.deepEqual(await violations(page), [], dialog);
        if (theme === 'light') await b.picture(page, `${name}_${dialog}`);
        await page.click(`#${dialog} [data-close]`);
      }
      await b.openFile(page, 'bad.off', 'OFF\nnothing\n');
      await b.problem(page);
      assert.deepEqual(await violations(page), [], 'problem');
      assert.deepEqual(await misplaced(page), [], 'problem');
      assert.deepEqual(page.faults, []);
    });

test('every control can be reached by the Tab key', async () => {
  const page = await b.open(session);
  await b.settled(page);
  await page.waitForFunction(() => !document.getElementById('detail').disabled);
  const reached = new Set();
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press('Tab');
    reached.add(
      await page.evaluate(() => document.activeElement.id || document.activeElement.name),
    );
  }
  for (const id of [
    'open',
    'examples',
    'share',
    'save',
    'theme',
    'help',
    'view',
    'fit',
    'tab-graph',
    'mode',
    'detail',
  ])
    assert.ok(reached.has(id), id);
});

test('without WebGL the page says so, and all but the picture is there', async () => {
  const blind = await b.start({ hasWebgl: false });
  try {
    const page = await b.open(blind);
    await b.settled(page);
    assert.ok(await b.isShown(page, '#no-picture'));
    assert.match(await b.text(page, '#no-picture'), /WebGL/);
    assert.ok((await b.numberOfArcs(page)) >= 4);
    await page.click('input[value="star"]');
    await b.untilChosen(page, ({ mode }) => mode === 'star', 'star');
    await page.focus('#arcs button');
    assert.match(await b.text(page, '#part-card'), /Part 1/);
    assert.deepEqual(await violations(page), []);
    await b.picture(page, '21_no_webgl');
  } finally {
    await blind.close();
  }
});
