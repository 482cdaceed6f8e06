#!/bin/sh
# Adds packages of a host to the server: `make add PACKAGE='gymnasium[box2d]'`. They get
# an environment of their own (.venv-own) beside everything that the server has, in the
# versions that are locked for it, so that `make setup` takes nothing away and what is
# tested stays as it is. requirements/own.in has what was added, own.txt its lock; both
# are this machine's. Without PACKAGE the lock is made again, after an update.
set -eu
. tools/uv_settings.sh
cd requirements
if [ $# -gt 0 ] && [ -z "$*" ]; then
    echo "add: name a package: make add PACKAGE='gymnasium[box2d]'" >&2
    exit 2
fi
new=$(mktemp own.XXXXXX)
trap 'rm -f "$new" "$new.txt"' EXIT
{
    if [ -f own.in ]; then cat own.in; else printf -- '-r server.in\nsetuptools\n'; fi
    # shellcheck disable=SC2086 # several packages, separated by spaces
    printf '%s\n' $*
} | sed '/^$/d' | awk '!seen[$0]++' > "$new"
# No compiler is needed: a package without wheels is an error. Nothing is kept of it.
# Locked versions stay: packages that need others are refused with the reason.
../.venv/bin/uv pip compile --quiet --no-config --no-header --python ../.venv/bin/python \
    --generate-hashes --only-binary :all: --no-emit-index-url --no-emit-find-links \
    --constraints dev.txt "$new" --output-file "$new.txt" > /dev/null
mv "$new.txt" own.txt
mv "$new" own.in
touch own.txt
cd ..
sh tools/setup.sh own
echo "add: .venv-own has $(grep -c == requirements/own.txt) packages; make serve uses it"
