"""From kernel and model to machine code on disk, and to programs that run it."""
