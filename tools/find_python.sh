#!/bin/sh
# Print the first Python that is new enough and can create environments.
# An argument names the only one to consider. It must not install anything:
# when there is none, it says in one line what is missing and how to get it.

# Exit code 3: too old. Exit code 4: cannot create environments.
probe='import sys
if sys.version_info < (3, 11): sys.exit(3)
try: import venv, ensurepip
except ImportError: sys.exit(4)'

without_venv=""
for candidate in ${1:-python3 python3.14 python3.13 python3.12 python3.11 python}; do
    command -v "$candidate" >/dev/null 2>&1 || continue
    "$candidate" -c "$probe" >/dev/null 2>&1
    case $? in
        0) command -v "$candidate"; exit 0 ;;
        4) without_venv=$candidate ;;
    esac
done

if [ -n "$without_venv" ]; then
    echo "set-up: $without_venv lacks the venv module; install it" \
        "(Debian, Ubuntu: apt-get install python3-venv) and run make again." >&2
elif [ -n "$1" ]; then
    echo "set-up: PYTHON=$1 is not a Python 3.11 or newer; name another one." >&2
else
    echo "set-up: no Python 3.11 or newer was found; install one" \
        "(Debian, Ubuntu: apt-get install python3 python3-venv)" \
        "or name it: make PYTHON=/path/to/python" >&2
fi
exit 1
