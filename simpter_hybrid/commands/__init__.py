"""The subcommands of ``simpter``, one file each.

A command module has ``HELP``, ``arguments(parser)`` and ``execute(args) -> exit code``, and imports
what is slow to import only in ``execute``.
"""

DONE, CHECK_FAILED, INVALID, FAILED, INTERRUPTED = 0, 1, 2, 3, 130
