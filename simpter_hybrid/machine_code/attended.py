"""Machine code that Ctrl-C can end: while it runs in the first thread, Python hears no signal."""

from __future__ import annotations

from collections.abc import Callable
from threading import Thread

#: Wall time between two looks at what machine code has done [s].
INTERVAL = 0.05


def attended(work: Callable[[], None], look: Callable[[], None], halt: Callable[[], None]) -> bool:
    """Do ``work`` in a thread of its own, which ends soon after ``halt``; whether it was let end.

    Parameters
    ----------
    work : callable
        Machine code; what it works on has to live as long as it does.
    look : callable
        Called now and then; a KeyboardInterrupt, its own or that of a signal, halts the work.
    halt : callable
    """
    failed: list[BaseException] = []

    def guarded() -> None:
        try:
            work()
        except BaseException as error:  # of a thread nobody would hear it
            failed.append(error)

    thread = Thread(target=guarded)
    try:
        thread.start()
        while thread.is_alive():
            thread.join(INTERVAL)
            if thread.is_alive():
                look()
    except KeyboardInterrupt:
        return False
    finally:
        halt()
        if thread.ident is not None:
            thread.join()
        if failed:
            raise failed[0]
    return True
