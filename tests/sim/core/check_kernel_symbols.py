"""What is compiled for more than any x86-64 has may leave the linker nothing that it could take for another file's:
check_kernel_symbols.py NM LIBRARY ... looks for weak symbols in the objects of *_simd.cpp. Exit 1 when
there are any, or no such objects.
"""
import re
import subprocess
import sys


def weak_symbols(nm, library):
    """Yields (object, symbol or None) for each kernel object in the library, and for each weak symbol in it."""
    listing = subprocess.run([nm, "-C", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    current = None
    for line in listing.splitlines():
        if line.endswith(":"):
            current = line[:-1] if re.search(r"_simd\.cpp", line) else None
            if current:
                yield current, None
        elif current and re.match(r"[0-9a-f]+ [WwVvu] ", line):
            yield current, line.split(" ", 2)[2]


def main(nm, libraries):
    found = [pair for library in libraries for pair in weak_symbols(nm, library)]
    weak = [(name, symbol) for name, symbol in found if symbol is not None]
    for name, symbol in weak:
        print(f"{name}: the linker may use this elsewhere: {symbol}")
    if not found:
        print("no kernels in " + ", ".join(libraries))
    return 1 if weak or not found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
