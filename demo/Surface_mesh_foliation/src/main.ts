// Puts the page together.
import { Busy } from './busy';
import { element } from './dom';
import { Abandoned, Engine, ProblemError } from './engine';
import { listenToKeys } from './keyboard';
import { Later } from './later';
import { Loop_drawing } from './loop_drawing';
import { Loop_walks } from './loop_walks';
import { Messages } from './messages';
import { Opening } from './opening';
import { Edit_panel } from './panels/edit_panel';
import { Graph_panel } from './panels/graph_panel';
import { showLegend } from './panels/legend';
import { Mesh_panel } from './panels/mesh_panel';
import { Show_panel } from './panels/show_panel';
import { Tabs } from './panels/tabs';
import { Part_card } from './part_card';
import { listenToPointer } from './pointer';
import { Pole_editor } from './poles';
import type { Result } from './protocol';
import { Saving } from './saving';
import { Session } from './session';
import { Sharing } from './sharing';
import { Theme_switch, inkOf } from './theme';
import { Tools } from './tools';
import { View } from './view/View';
import type { ScreenPoint } from './view/View';
import { asSentence, forPeople } from './wording';

const REACH = 12; // pixels around the marker of a pole that grab it
const REACH_OF_FINGER = 24;

const canvas = element<HTMLCanvasElement>('view');
const theme = new Theme_switch(document.documentElement);
const messages = new Messages(element('messages'));
const engine = new Engine(() => new Worker('worker.js'));
const session = new Session(engine);
const view = makeView();
const busy = new Busy(() => session.cancel());
const card = new Part_card(view);
const poles = new Pole_editor(session, view);
const tools = new Tools();
const drawing = new Loop_drawing(session, view, () => tools.choose('look'));
const walks = new Loop_walks(session);
const tabs = new Tabs();
const graphPanel = new Graph_panel(session, view, card);
const showPanel = new Show_panel();
new Edit_panel(session, poles);
const opening: Opening = new Opening(session, messages, () => meshPanel);
const meshPanel: Mesh_panel = new Mesh_panel(session, () => void opening.openAgain());
const buttons = new Later(updateButtons);
const saving = new Saving(session, view);
new Sharing(session);

function makeView(): View | null {
  try {
    return new View(canvas, inkOf(theme.current));
  } catch {
    element('no-picture').hidden = false;
    for (const id of ['view', 'tools', 'hint', 'fit']) element(id).hidden = true;
    return null;
  }
}

// ---- what the session tells

session.opened.on((loaded) => {
  view?.showMesh(loaded);
  messages.clearProblem();
  if (loaded.repair.length > 0) messages.notice(asSentence(loaded.repair.join('; ')));
});

session.stateChanged.on((state) => {
  view?.showState(state);
  messages.clearProblem();
  view?.showFaults([]);
  buttons.soon();
});

session.sketched.on((sketch) => {
  view?.showSketch(sketch);
  whenDrawn(() => {
    document.body.dataset.sketched = String(Math.round(performance.now()));
  });
});

session.resultChanged.on((result) => {
  view?.showResult(result);
  card.setResult(result);
  showResultInPanels(result);
  buttons.now();
  if (!result) return;
  for (const note of result.notes) messages.notice(asSentence(note));
  document.body.dataset.timing = JSON.stringify(session.timing);
  whenDrawn(() => {
    document.body.dataset.drawn = String(Math.round(performance.now()));
  });
  if (session.isProvisional) return;
  if (showPanel.layers.leaves) void showLeaves();
  if (showPanel.layers.loops || tools.current === 'loop') void showLoops();
  if (!session.isPreview) void session.wantHierarchy();
});

session.problemMet.on((problem) => {
  const repair = { label: 'Repair it', act: () => void opening.repairAndOpen() };
  messages.showProblem(
    asSentence(forPeople(problem.message)),
    opening.canRepair(problem.kind) ? repair : undefined,
  );
  if (!opening.isRefused) view?.showFaults(problem.vertices);
});

session.noticed.on((text) => messages.notice(text));

engine.onBusy = (isBusy) => busy.set(isBusy);
engine.onProgress = (progress) => busy.progress(progress);

function showResultInPanels(result: Result | null): void {
  graphPanel.showResult(result, showPanel.layers.coloring);
  showLegend(result, showPanel.layers.coloring);
}

function updateButtons(): void {
  element<HTMLButtonElement>('undo').disabled = !session.canUndo;
  element<HTMLButtonElement>('redo').disabled = !session.canRedo;
  for (const id of ['share', 'save']) element<HTMLButtonElement>(id).disabled = !session.result;
}

function whenDrawn(act: () => void): void {
  requestAnimationFrame(() => requestAnimationFrame(act));
}

// ---- what the picture shows

showPanel.changed.on((layers) => {
  card.coloring = layers.coloring;
  view?.setLayers(layers);
  card.show();
  showResultInPanels(session.result);
  if (layers.leaves) void showLeaves();
  if (layers.loops) void showLoops();
});

let leavesWanted = 0;

/** While leaves are computed, only the newest wish is kept. */
async function showLeaves(): Promise<void> {
  const wish = ++leavesWanted;
  await Promise.resolve();
  if (wish !== leavesWanted || !session.result) return;
  const { result } = session;
  await quietly(async () => {
    const leaves = await session.leaves(showPanel.layers.leavesPerArc);
    if (wish === leavesWanted && result === session.result) view?.showLeaves(leaves);
  });
}

async function showLoops(): Promise<void> {
  const { result } = session;
  if (!result) return;
  await quietly(async () => {
    const shown = await walks.of(result.state.loops);
    if (result === session.result) view?.showLoops(shown);
  });
}

async function quietly(act: () => Promise<void>): Promise<void> {
  try {
    await act();
  } catch (error) {
    if (!(error instanceof Abandoned || error instanceof ProblemError)) throw error;
  }
}

theme.changed.on((current) => view?.setInk(inkOf(current)));

// ---- pointer and keys

function clickAt(point: ScreenPoint): void {
  if (!view) return;
  if (tools.current === 'look') {
    card.keep(view.arcAt(point));
    return;
  }
  const vertex = view.vertexAt(point);
  if (vertex === null) {
    poles.select(null);
    return;
  }
  if (tools.current === 'poles') poles.addAt(vertex);
  else drawing.add(vertex);
}

tools.changed.on((tool) => {
  if (tool !== 'loop') drawing.clear();
  if (tool !== 'poles') poles.select(null);
  if (tool !== 'look') card.hover(null);
  if (tool === 'poles') tabs.open('edit');
  view?.forceLoops('drawing', tool === 'loop');
  if (tool === 'loop') void showLoops();
});

if (view) {
  const stage = element('stage');
  listenToPointer(
    canvas,
    {
      hover(point) {
        const isOnPole =
          tools.current === 'poles' && point !== null && view.poleAt(point, REACH) !== null;
        stage.classList.toggle('on-pole', isOnPole);
        if (tools.current === 'look') card.hover(point ? view.arcAt(point) : null);
      },
      click: (point, isTouch) => {
        const pole =
          tools.current === 'poles' ? view.poleAt(point, isTouch ? REACH_OF_FINGER : REACH) : null;
        if (pole === null) clickAt(point);
      },
      grab: (point, isTouch) => {
        const isGrabbed =
          tools.current === 'poles' && poles.grab(point, isTouch ? REACH_OF_FINGER : REACH);
        stage.classList.toggle('dragging', isGrabbed);
        return isGrabbed;
      },
      drag: (point) => poles.drag(point),
      drop: (point) => {
        stage.classList.remove('dragging');
        poles.drop(point);
      },
      abandonDrag: () => {
        stage.classList.remove('dragging');
        poles.abandonDrag();
      },
    },
    (isOn) => {
      view.isTurnedByPointer = isOn;
      if (isOn) stage.classList.remove('dragging');
    },
  );
  // for tests and consoles: where a vertex is in the window
  Object.assign(canvas, {
    screenPosition: (vertex: number) => ({
      ...view.screenPosition(vertex),
      isVisible: view.isVisible(vertex),
    }),
  });
}

listenToKeys(canvas, {
  undo: () => void session.undo(),
  redo: () => void session.redo(),
  open: () => opening.choose(),
  save: () => saving.open(),
  help: () => element<HTMLDialogElement>('help-dialog').showModal(),
  chooseLook: () => tools.choose('look'),
  choosePoles: () => tools.choose('poles'),
  chooseLoop: () => tools.choose('loop'),
  frame: () => view?.frame(),
  turn: (right, up) => view?.turn(right, up),
  zoom: (factor) => view?.zoom(factor),
  clickAtCenter: () => {
    if (view) clickAt(view.center);
  },
  moveToCenter: () => {
    const vertex = view?.vertexAt(view.center) ?? null;
    if (vertex !== null) poles.moveSelectedTo(vertex);
  },
  remove: () => {
    if (poles.selected !== null) poles.remove(poles.selected);
  },
  takeBack: () => drawing.takeBack(),
  finish: () => drawing.finish(),
  escape: () => {
    if (busy.isShown) session.cancel();
    else if (!drawing.isEmpty) drawing.clear();
    else {
      messages.clearProblem();
      poles.select(null);
      card.keep(null);
    }
  },
});

canvas.addEventListener('focus', () => {
  element('crosshair').hidden = !canvas.matches(':focus-visible');
});
canvas.addEventListener('blur', () => {
  element('crosshair').hidden = true;
});
canvas.addEventListener('pointerdown', () => {
  element('crosshair').hidden = true;
});

// ---- buttons

element('undo').addEventListener('click', () => void session.undo());
element('redo').addEventListener('click', () => void session.redo());
element('save').addEventListener('click', () => saving.open());
element('theme').addEventListener('click', () => theme.toggle());
element('fit').addEventListener('click', () => view?.frame());
element('help').addEventListener('click', () =>
  element<HTMLDialogElement>('help-dialog').showModal(),
);
for (const button of document.querySelectorAll<HTMLButtonElement>('[data-close]'))
  button.addEventListener('click', () => button.closest('dialog')!.close());
void opening.start();
