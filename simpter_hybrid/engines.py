"""The engines by name; the first is the one that runs unless another is asked for."""

ENGINES = ("reference", "compiled")
