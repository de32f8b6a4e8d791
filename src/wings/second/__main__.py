"""Starts the verifier: python3 dumbbell-verify.pyz FILE..., or python3 src/wings/second FILE... in a clone."""

import os
import signal
import sys

if sys.version_info < (3, 8):
    sys.stderr.write("dumbbell-verify.pyz: needs Python 3.8 or later\n")
    sys.exit(2)

# Ctrl-C, and a reader that has gone, end it like any other program.
for name in ("SIGINT", "SIGPIPE"):
    if hasattr(signal, name):
        signal.signal(getattr(signal, name), signal.SIG_DFL)

sys.dont_write_bytecode = True  # leaves no folder behind in a source tree
try:
    from program import main

    code = main(sys.argv[1:])
except MemoryError:
    sys.stderr.write("dumbbell-verify.pyz: resource limit: out of memory\n")
    code = 4
os._exit(code)  # all is flushed: no second attempt to write, which would change the code
