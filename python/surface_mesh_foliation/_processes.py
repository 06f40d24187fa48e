# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes of this machine, which end with the process that started them."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from concurrent.futures import ProcessPoolExecutor
from multiprocessing.connection import Connection, wait
from typing import Any


class Processes(ProcessPoolExecutor):
    """A pool whose workers leave Ctrl-C to the process that started them, and end with it."""

    def __init__(self, workers: int) -> None:
        reader, self._writer = multiprocessing.Pipe(duplex=False)
        self._has_ended = False
        super().__init__(workers, initializer=_start, initargs=(reader,))

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Shut down; without waiting, what workers are doing is given up."""
        if not wait and not self._has_ended:
            self._has_ended = True
            self._writer.send_bytes(b"end")
        super().shutdown(wait, cancel_futures=cancel_futures)


def _start(reader: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end, args=(reader,), daemon=True).start()


def _end(reader: Connection) -> None:
    """End this worker when it is told to, or when the process that started it has ended.

    What is told is not read, so that all workers are told by it.
    """
    parent: Any = multiprocessing.parent_process()
    wait([reader, parent.sentinel])
    os._exit(1)
