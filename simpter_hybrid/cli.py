"""The command line: ``simpter COMMAND``, see ``COMMANDS``.

Exit codes: 0 done; 1 a check failed; 2 usage or invalid input; 3 the simulation failed, what there
was is kept; 130 interrupted, what there was is kept. Data go to stdout, all else to stderr.
"""

from __future__ import annotations

import argparse
import errno
import importlib
import os
import sys
from collections.abc import Sequence

from .commands import DONE, FAILED, INTERRUPTED, INVALID
from .problems import CompiledUnavailable, InvalidInput

#: What a disk says that takes no more; other errors of the system are faults of ours.
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EFBIG, errno.EIO)

#: Name of every command; its module is ``commands.<name>``.
COMMANDS = (
    "list", "show", "check", "run", "sweep", "explain", "compare", "diagnose", "reproduce", "study",
)  # fmt: skip

#: Commands that never write a file.
READING = ("list", "show", "check", "explain")

ABOUT = """Event-driven simulation of devices with controlled friction.

  simpter list                   the scenarios that come with the program
  simpter run line-y24           run one; its files go to out/line-y24
  simpter explain out/line-y24 --at 0.9     why did it slip there?
"""


class Parser(argparse.ArgumentParser):
    """argparse, with messages in the form of all others."""

    def error(self, message: str):
        self.exit(INVALID, f"{self.prog}: {message}; see {self.prog} --help\n")


def parser() -> Parser:
    """The parser of all commands."""
    top = Parser(
        prog="simpter", description=ABOUT, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    top.add_argument("--version", action="store_true", help="print the version and end")
    commands = top.add_subparsers(metavar="COMMAND", parser_class=Parser)
    for name in COMMANDS:
        module = importlib.import_module(f"simpter_hybrid.commands.{name}")
        its = commands.add_parser(name, help=module.HELP, description=module.__doc__)
        module.arguments(its)
        its.set_defaults(execute=module.execute, prog=f"simpter {name}")
    return top


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit code.

    Parameters
    ----------
    argv : sequence of str, optional
        What follows the program's name; by default what it was started with.
    """
    top = parser()
    args = top.parse_args(argv)
    if args.version:
        from .versions import own_version

        print(own_version())
        return DONE
    if not hasattr(args, "execute"):
        top.error(f"no command; one of {', '.join(COMMANDS)} is needed")
    try:
        return args.execute(args)
    except InvalidInput as error:
        report_invalid(error, args)
        return INVALID
    except CompiledUnavailable as error:
        otherwise = "--engine reference" if hasattr(args, "engine") else ""
        report_invalid(error.invalid(args.prog, otherwise), args)
        return INVALID
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            # Whoever read our output has gone; nothing is to be said on a closed pipe.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return DONE
        if error.errno not in FULL:
            raise
        where = f"{error.filename}: " if error.filename else ""
        print(
            f"not written: {where}{os.strerror(error.errno or 0).lower()}; "
            "make room there or give another directory (--out)",
            file=sys.stderr,
        )
        return FAILED


def report_invalid(error: InvalidInput, args: argparse.Namespace) -> None:
    """All problems on stderr, and on stdout as data where data were asked for.

    Parameters
    ----------
    error : InvalidInput
    args : Namespace
        Of the command: its ``prog``, and ``json`` where it has that option.
    """
    count = len(error.problems)
    told = "" if args.prog.removeprefix("simpter ") in READING else "; nothing was written"
    print(error, file=sys.stderr)
    print(f"{count} problem{'s' if count != 1 else ''}{told}", file=sys.stderr)
    if getattr(args, "json", False):
        import json

        found = {"problems": [problem._asdict() for problem in error.problems]}
        print(json.dumps(found, indent=2))


if __name__ == "__main__":
    sys.exit(main())
