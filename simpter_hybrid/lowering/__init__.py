"""A compiler for the kernel's and the parts' dialect of Python: scalars, flat arrays, loops.

The dialect is what ``part.py`` asks for, so that one text runs as Python and as machine code.  A
general just-in-time compiler (Numba) took forty seconds for the kernel; this one takes about three.
"""
