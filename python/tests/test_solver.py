# SPDX-License-Identifier: GPL-3.0-or-later
"""One result after another: edits, progress, and what stops a run."""

import copy
import os
import pickle
import signal
import sys
import threading
import time
import types

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf


def same(first, second):
    np.testing.assert_array_equal(first.ends, second.ends)
    np.testing.assert_allclose(first.fluxes, second.fluxes, rtol=1e-9)
    np.testing.assert_allclose(first.edge_values, second.edge_values, atol=1e-9)


def test_a_solver_gives_what_the_function_gives(body, body_result):
    same(smf.Solver(body).solve(), body_result)


def test_edits_give_what_is_given_at_once(body):
    poles = smf.find_poles(body).tolist()
    solver = smf.Solver(body, poles=poles, loops=[])
    solver.solve()
    solver.set_height(2, 3.0)
    same(solver.solve(), smf.reeb_graph(body, poles=poles, loops=[], heights=[1, 1, 3, 1, 1]))
    solver.move_pole(1, 100)
    moved = poles[:1] + [100] + poles[2:]
    same(solver.solve(), smf.reeb_graph(body, poles=moved, loops=[], heights=[1, 1, 3, 1, 1]))
    assert solver.add_pole(200, height=2.0) == 5
    heights = [1, 1, 3, 1, 1, 2]
    same(solver.solve(), smf.reeb_graph(body, poles=moved + [200], loops=[], heights=heights))
    solver.remove(2)
    moved = moved[:2] + moved[3:]
    heights = [1, 1, 1, 1, 2]
    same(solver.solve(), smf.reeb_graph(body, poles=moved + [200], loops=[], heights=heights))


def test_loops_can_be_added_and_removed(body, body_result):
    solver = smf.Solver(body)
    assert len(solver.loops) == 6 and not solver.loops[5].is_pole
    loop = body_result.loops[5]
    solver.remove(5)
    assert solver.solve().number_of_arcs == 5
    assert solver.add_loop(loop) == 5
    same(solver.solve(), body_result)
    solver.add_loop(loop)
    found = solver.problems()
    assert found and all(isinstance(problem, smf.LoopsError) for problem in found)
    assert set(found[0].loops) == {5, 6}
    with pytest.raises(smf.LoopsError):
        solver.solve()
    solver.remove(6)
    assert solver.problems() == []
    same(solver.solve(), body_result)


def test_a_solver_can_be_pickled_and_copied(body):
    weights = np.linspace(1, 2, body.number_of_edges)
    solver = smf.Solver(body, weights=weights, max_iterations=50, samples=3)
    solver.set_height(1, 2.0)
    first = solver.solve()
    for other in (pickle.loads(pickle.dumps(solver)), copy.copy(solver)):
        same(other.solve(), first)
        assert other.solve().skeleton.swc() == first.skeleton.swc()
        assert list(other.solve().canonical_loops) == [5]
        other.set_height(1, 3.0)
        assert other.solve().heights[1] == 3 and solver.solve().heights[1] == 2


def test_results_of_a_solver_do_not_change(body):
    solver = smf.Solver(body)
    first = solver.solve()
    kept = first.t.copy(), first.fluxes.copy()
    solver.set_height(0, 5.0)
    second = solver.solve()
    np.testing.assert_array_equal(first._core.vertex_cells()[2], kept[0])
    assert first.heights[0] == 1 and second.heights[0] == 5
    assert np.array_equal(first.fluxes, kept[1]) and not np.array_equal(second.fluxes, kept[1])


def test_what_was_found_is_told_after_edits(body):
    solver = smf.Solver(body)
    solver.set_height(0, 2.0)
    assert list(solver.solve().canonical_loops) == [5]
    solver.remove(5)
    assert solver.solve().canonical_loops == {}
    solver = smf.Solver(body)
    solver.move_pole(3, 50)
    r = solver.solve()
    assert r.canonical_loops == {} and np.isnan(r.poles[3].significance)
    assert not np.isnan(r.poles[2].significance)
    assert len(r.hierarchy.loops) == 2


@pytest.mark.parametrize(
    "edit, error",
    [
        (lambda s: s.move_pole(0, -1), ValueError),
        (lambda s: s.move_pole(0, 10**9), ValueError),
        (lambda s: s.move_pole(0, 1.0), TypeError),
        (lambda s: s.move_pole(-1, 5), IndexError),
        (lambda s: s.move_pole(6, 5), IndexError),
        (lambda s: s.move_pole(5, 5), ValueError),
        (lambda s: s.set_height(6, 1.0), IndexError),
        (lambda s: s.set_height(0, 0.0), ValueError),
        (lambda s: s.set_height(0, float("inf")), ValueError),
        (lambda s: s.set_height(0, "1"), TypeError),
        (lambda s: s.add_pole(10**9), ValueError),
        (lambda s: s.add_pole([]), ValueError),
        (lambda s: s.add_loop(3), TypeError),
        (lambda s: s.remove(6), IndexError),
    ],
)
def test_wrong_edits_are_refused_and_change_nothing(body, edit, error):
    solver = smf.Solver(body)
    before = solver.loops
    with pytest.raises(error):
        edit(solver)
    assert all(x is y for x, y in zip(solver.loops, before)) and len(solver.loops) == len(before)


def test_an_opening_cannot_be_moved(tube):
    with pytest.raises(ValueError, match="opening"):
        smf.Solver(tube).move_pole(0, 100)


def test_progress_is_told(body):
    told = []
    r = smf.reeb_graph(body, progress=told.append)
    assert all(isinstance(p, smf.Progress) for p in told)
    own = [p for p in told if p.vertices == body.number_of_vertices]
    assert [p.iteration for p in own] == list(range(1, len(own) + 1))
    assert own[-1].optimality == pytest.approx(r.certificate.optimality, abs=1e-12)


def test_progress_can_be_shown(body, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)  # as if it were not installed
    smf.reeb_graph(body, progress=True)
    assert "iteration" in capsys.readouterr().err


def test_progress_is_shown_by_tqdm_if_it_is_there(body, monkeypatch):
    class Bar:
        texts, is_closed = [], False

        def __init__(self, **options):
            pass

        def __enter__(self):
            return self

        def __exit__(self, *error):
            Bar.is_closed = True

        def set_description_str(self, text):
            Bar.texts.append(text)

        def update(self):
            pass

    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar))
    smf.reeb_graph(body, progress=True)
    assert Bar.is_closed and f"{body.number_of_vertices} vertices" in Bar.texts[-1]


def test_a_function_that_returns_false_stops_softly(body):
    r = smf.reeb_graph(body, progress=lambda progress: False)
    assert r.certificate.holds and not r.certificate.has_converged
    assert smf.reeb_graph(body, progress=lambda progress: None).certificate.has_converged


def test_what_a_function_raises_ends_the_run(body):
    class Enough(Exception):
        pass

    def stop(progress):
        raise Enough(progress.vertices)

    solver = smf.Solver(body)
    with pytest.raises(Enough):
        solver.solve(stop)
    assert solver.solve().certificate.has_converged


def test_a_solver_at_work_turns_others_away(body):
    solver = smf.Solver(body)
    refused = []

    def again(progress):
        with pytest.raises(RuntimeError, match="at work"):
            solver.solve()
        refused.append(progress)

    assert solver.solve(again).certificate.has_converged and refused


def test_few_iterations_give_a_certified_result(body):
    r = smf.reeb_graph(body, max_iterations=0)
    assert r.certificate.holds


@pytest.fixture(scope="module")
def large():
    return smf.Mesh(*shapes.torus(120, 240))


def test_other_threads_run_meanwhile(large):
    counts, is_done = [0], threading.Event()

    def count():
        while not is_done.is_set():
            counts[0] += 1
            time.sleep(0.0005)

    thread = threading.Thread(target=count)
    thread.start()
    try:
        solver = smf.Solver(large, poles=[0, 5000, 20000], star=True)
        before = counts[0]
        solver.solve()
        after = counts[0]
    finally:
        is_done.set()
        thread.join()
    assert after - before > 5  # on an idle machine hundreds; none if the solver did not let go


def test_threads_may_share_meshes_and_results(body, body_result):
    results, errors = [], []

    def work():
        try:
            r = smf.reeb_graph(body)
            results.append((r.fluxes, body_result.embed(5).length, body_result.leaf(5, 0.5).length))
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not errors and len(results) == 4
    for fluxes, *lengths in results:
        np.testing.assert_array_equal(fluxes, results[0][0])
        assert lengths == list(results[0][1:])


def test_control_c_ends_a_run(large):
    solver = smf.Solver(large, poles=[0, 5000, 20000], star=True)
    timer = threading.Timer(0.02, os.kill, (os.getpid(), signal.SIGINT))
    finished = []
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100):
            solver.move_pole(1, 5000 + len(finished))
            finished.append(solver.solve())
    timer.join()
    assert solver.solve().certificate.has_converged


@pytest.mark.parametrize("kind", ["poles", "loops"])
def test_a_signal_handler_ends_a_search(large, kind):
    """It is called again and again while the search runs, not once behind it."""

    class Alarm(Exception):
        pass

    def search():
        if kind == "poles":
            smf.find_poles(large)
        else:
            smf.loop_hierarchy(large, np.linspace(0, large.number_of_vertices - 1, 9).astype(int))

    calls = []

    def raise_at_third_call(number, frame):
        calls.append(number)
        if len(calls) == 3:
            raise Alarm

    begin = time.perf_counter()
    search()
    period = (time.perf_counter() - begin) / 10
    previous = signal.signal(signal.SIGALRM, raise_at_third_call)
    signal.setitimer(signal.ITIMER_REAL, period, period)
    try:
        with pytest.raises(Alarm):
            search()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
    assert len(calls) == 3


def test_a_signal_handler_is_called_within_a_run(large):
    class Alarm(Exception):
        pass

    def raise_alarm(number, frame):
        raise Alarm

    iterations = []

    def arm(progress):
        iterations.append(progress)
        if progress.vertices == large.number_of_vertices:
            os.kill(os.getpid(), signal.SIGUSR1)

    old = signal.signal(signal.SIGUSR1, raise_alarm)
    try:
        with pytest.raises(Alarm):
            smf.reeb_graph(large, poles=[0, 5000, 20000], star=True, progress=arm)
    finally:
        signal.signal(signal.SIGUSR1, old)
    assert iterations
