"""What a sweep has written, to be compared byte by byte."""


def files(out):
    """Contents of every file below a folder, by its place in it."""
    return {str(f.relative_to(out)): f.read_bytes() for f in out.rglob("*.*") if f.is_file()}
