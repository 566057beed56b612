"""Work for worker processes that they do, or that ends them."""

import atexit
import os
import threading
import time


def ready(*offsets):
    """Prepare a worker: it answers with what the task asks for."""

    def work(task, progress):
        what, value = task
        match what:
            case "add":
                return value + sum(offsets)
            case "sleep":
                time.sleep(value)
            case "exit":
                os._exit(value)
            case "signal":
                os.kill(os.getpid(), value)
            case "raise":
                raise ValueError(value)
            case "lock":
                return threading.Lock()
            case "process":
                return os.getpid()
            case "environment":
                return os.environ.get(value)
            case "at exit":
                atexit.register(open, value, "w")
            case "memory":
                return bytearray(value)
            case "progress":
                for i in range(value):
                    progress(i / value)
        return what

    return work


def unready():
    """Fail to prepare a worker."""
    raise ImportError("no such solver here")


def slow(seconds):
    """Prepare a worker as imports do that take long."""
    time.sleep(seconds)
    return ready()
