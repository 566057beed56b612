import os
import signal
import time

import pytest

from vmharness.execution.message import Began, Done, Lost, Progress, Raised
from vmharness.execution.pool import Pool
from vmharness.execution.worker import ONE_THREAD


def ends(pool, tasks, **options):
    """The last message of each task, by its number; every task must have just one such, after its Began."""
    found, begun = {}, set()
    for number, message in pool.each(tasks, **options):
        if isinstance(message, Began):
            assert number not in begun
            begun.add(number)
        elif not isinstance(message, Progress):
            assert number in begun
            assert number not in found
            found[number] = message
    assert set(found) == set(range(len(tasks)))
    return found


def test_every_task_is_done_once_and_workers_are_reused(work):
    with Pool(2, work.ready, 100) as pool:
        found = ends(pool, [("add", i) for i in range(20)])
        processes = {end.value for end in ends(pool, [("process", 0)] * 20).values()}
    assert found == {i: Done(100 + i) for i in range(20)}
    assert 1 <= len(processes) <= 2
    assert os.getpid() not in processes


def test_a_crash_loses_its_own_task_alone(work):
    tasks = [("add", 1), ("exit", 3), ("add", 2), ("signal", signal.SIGSEGV), ("add", 3)]
    with Pool(1, work.ready) as pool:
        found = ends(pool, tasks)
    assert [found[i] for i in (0, 2, 4)] == [Done(1), Done(2), Done(3)]
    assert found[1] == Lost("the worker process ended: exit code 3")
    assert found[3] == Lost("the worker process ended: killed by SIGSEGV")


def test_a_task_whose_worker_is_killed_from_outside_is_lost_so(work):
    tasks = [("signal", signal.SIGKILL), ("add", 1), ("signal", signal.SIGABRT)]
    with Pool(1, work.ready) as pool:
        found = ends(pool, tasks)
    assert found[0] == Lost("the worker process ended: killed by SIGKILL", outside=True)
    assert found[1] == Done(1)
    assert found[2] == Lost("the worker process ended: killed by SIGABRT")  # its own doing


def test_a_task_has_a_worker_that_is_prepared_for_it(work):
    tasks = [("add", 1), ("process", 0), ("process", 0), ("add", 1), ("process", 0)]
    with Pool(1, work.ready, 100) as pool:
        found = ends(pool, tasks, arguments=[(100,), (100,), (100,), (200,), (200,)])
    assert [found[0], found[3]] == [Done(101), Done(201)]
    assert found[1] == found[2] != found[4]


def test_a_hanging_worker_is_killed_and_replaced(work):
    with Pool(1, work.ready) as pool:
        assert ends(pool, [("add", 1)]) == {0: Done(1)}  # it has started
        began = time.monotonic()
        found = ends(pool, [("sleep", 600), ("add", 2)], timeout=2.0)
    assert found == {0: Lost("not done after 2 s, the time limit"), 1: Done(2)}
    assert time.monotonic() - began < 300


def test_the_time_limit_begins_when_the_worker_is_ready(work):
    with Pool(1, work.slow, 3.0) as pool:
        assert ends(pool, [("add", 1), ("add", 2)], timeout=2.0) == {0: Done(1), 1: Done(2)}


def test_a_worker_that_is_never_ready_is_given_up(work, monkeypatch):
    monkeypatch.setattr("vmharness.execution.pool.PREPARING", 1.0)
    with Pool(1, work.slow, 600.0) as pool:
        found = ends(pool, [("add", 1)])
    assert found == {0: Lost("not ready to begin after 1 s, the time limit")}


def test_a_task_that_asks_for_all_memory_fails_alone(work):
    with Pool(1, work.ready) as pool:
        found = ends(pool, [("memory", 2**40), ("add", 1)])
    assert found[0].error.startswith("MemoryError")
    assert found[1] == Done(1)


def test_an_exception_is_told_with_its_traceback(work):
    with Pool(1, work.ready) as pool:
        found = ends(pool, [("raise", "bad deck"), ("add", 1)])
    assert found[0].error == "ValueError: bad deck"
    assert "pool_work.py" in found[0].traceback
    assert found[1] == Done(1)


def test_a_result_that_cannot_be_sent_is_an_error_of_its_task(work):
    with Pool(1, work.ready) as pool:
        found = ends(pool, [("lock", 0), ("add", 1)])
    assert isinstance(found[0], Raised)
    assert "lock" in found[0].error
    assert found[1] == Done(1)


def test_what_cannot_be_prepared_fails_every_task(work):
    with Pool(1, work.unready) as pool:
        found = ends(pool, [1, 2])
    assert [found[i].error for i in (0, 1)] == ["ImportError: no such solver here"] * 2


def test_progress_arrives_between_start_and_end_and_not_too_often(work):
    with Pool(1, work.ready) as pool:
        messages = [message for _, message in pool.each([("progress", 100_000)])]
    assert isinstance(messages[0], Began)
    assert isinstance(messages[-1], Done)
    fractions = [message.fraction for message in messages[1:-1]]
    assert fractions
    assert fractions == sorted(fractions)
    assert len(fractions) < 10_000


@pytest.mark.parametrize("name", ONE_THREAD)
def test_a_worker_has_one_thread(work, name):
    with Pool(1, work.ready) as pool:
        assert ends(pool, [("environment", name)]) == {0: Done("1")}


def test_workers_ignore_ctrl_c(work):
    with Pool(1, work.ready) as pool:
        found = ends(pool, [("signal", signal.SIGINT), ("add", 1)])
    assert found == {0: Done("signal"), 1: Done(1)}


def test_leaving_the_pool_ends_what_still_runs(work):
    with Pool(1, work.ready) as pool:
        process = ends(pool, [("process", 0)])[0].value
        assert next(pool.each([("sleep", 600)])) == (0, Began())
    with pytest.raises(ProcessLookupError):
        os.kill(process, 0)


def test_a_worker_that_died_between_tasks_is_replaced(work):
    with Pool(1, work.ready) as pool:
        process = ends(pool, [("process", 0)])[0].value
        os.kill(process, signal.SIGKILL)
        for worker in pool._workers:
            worker.process.join()
        assert ends(pool, [("add", 1)]) == {0: Done(1)}


def test_a_worker_ends_without_the_end_of_python_where_threads_would_abort_it(work, tmp_path):
    with Pool(1, work.ready) as pool:
        assert ends(pool, [("at exit", tmp_path / "written")]) == {0: Done("at exit")}
        (worker,) = pool._workers
        worker.connection.close()
        worker.process.join(60)
        assert worker.process.exitcode == 0
    assert not (tmp_path / "written").exists()
