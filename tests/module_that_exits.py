"""Named by a broken scenario: importing it asks to end the program."""

import sys

sys.exit(0)
