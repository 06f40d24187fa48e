// node test/make_pictures.mjs: makes the manual's pictures of the page that build.sh has made.
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import * as b from './browser/browser.mjs';
import { body, toOff } from './browser/meshes.mjs';

const figures = path.join(
  path.dirname(fileURLToPath(import.meta.url)),
  '../../../doc/Surface_mesh_foliation/fig',
);
const viewport = { width: 1120, height: 630 };
const session = await b.start();

async function take(page, name) {
  await b.smooth(page);
  await page.screenshot({ path: path.join(figures, name) });
}

try {
  const page = await b.open(session, { viewport });
  await b.settled(page);
  await b.setSlider(page, '#spacing', 24);
  await b.idle(page);
  await page.waitForFunction(() => !document.getElementById('detail').disabled);
  await page.click('#arcs tbody tr:last-child');
  await page.mouse.move(10, 200);
  await take(page, 'page.png');

  const [rings, sectors] = [60, 48];
  const drawing = await b.open(session, { viewport });
  await b.settled(drawing);
  await b.openFile(drawing, 'body.off', toOff(body(rings, sectors)));
  await drawing.waitForFunction(() =>
    document.getElementById('numbers').textContent.includes('body'),
  );
  await b.settled(drawing);
  await b.choose(drawing, 'loop');
  const waist = [0, 8, 16, 24, 32].map((sector) => 1 + 34 * sectors + sector);
  await b.pick(drawing, waist);
  await take(drawing, 'page_loop.png');
} finally {
  await session.close();
}
