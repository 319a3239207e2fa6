"""One axis, or two driven joints: driven, moved from outside, by set points, or let alone."""
