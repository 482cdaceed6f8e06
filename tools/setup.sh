#!/bin/sh
# Makes an environment equal to its lock: `sh tools/setup.sh dev` (.venv), `aloha`,
# `bench`, `cluster`, `generate`, `lerobot`, `libero`, `metaworld`, `own` or
# `robosuite` (.venv-NAME). uv does the work; here is what uv cannot do: pip brings uv itself, by the
# hash in the lock, to a machine that has nothing but Python, and root on Debian or Ubuntu
# gets the GL libraries that camera images need. PYTHON names the Python to use; otherwise
# the first for which the locks have wheels.
set -eu
name=$1
environment=.venv-$name
if [ "$name" = dev ]; then environment=.venv; fi
. tools/uv_settings.sh
uv=.venv/bin/uv
probe='import ensurepip, venv, sys; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 14))'

say() {
    echo "set-up: $*" >&2
}

stop() {
    say "$@"
    exit 1
}

# Runs a command that fetches packages. Where the index is not reached, the last line says
# so, and which proxy was tried: the words of the installers would name a package.
fetch() {
    log=.venv/fetch.log
    if "$@" 2> "$log"; then
        cat "$log" >&2
        return
    fi
    unreached='connection|connect error|resolve host|name resolution|timed out|proxy'
    unreached="$unreached|lookup address|error sending request"
    if ! grep -qiE "$unreached" "$log"; then
        cat "$log" >&2
        stop "the packages were not installed, for the reason above; repeat the command" \
            "then. Without internet: docs/host/without-internet.md"
    fi
    through="without a proxy: no variable such as https_proxy names one"
    for variable in https_proxy HTTPS_PROXY all_proxy ALL_PROXY; do
        eval "proxy=\${$variable:-}"
        if [ "$proxy" ]; then
            address=$(echo "$proxy" | sed 's|//.*@|//|')
            through="through the proxy $address, which $variable names"
            break
        fi
    done
    stop "the package index cannot be reached $through. Connect this machine or correct" \
        "the proxy, then repeat the command; nothing is lost. Without internet:" \
        "docs/host/without-internet.md"
}

install_uv() {
    say "making $environment, once; it takes half a minute, longer on a slow network"
    for python in ${PYTHON:-python3 python3.14 python3.13 python3.12 python3.11}; do
        "$python" -c "$probe" 2> /dev/null && break
        python=
    done
    [ "$python" ] || stop "no Python 3.11 to 3.14 that has the module venv; install one" \
        "(Debian, Ubuntu: apt-get install python3-venv) or name it: make PYTHON=..."
    "$python" -m venv --clear .venv
    say "fetching the installer, uv"
    grep '^uv==' requirements/hashes.txt > .venv/uv.txt
    fetch .venv/bin/python -m pip install --quiet --disable-pip-version-check --no-input \
        --require-hashes --no-deps --only-binary :all: --requirement .venv/uv.txt
}

provide_rendering() {
    probe="$environment/bin/python -m reference_sim.mujoco.rendering"
    if $probe > /dev/null 2>&1; then return; fi
    sh tools/debian_packages.sh "for camera images" libegl1 libopengl0 libgl1-mesa-dri || true
    problem=$($probe 2>&1) ||
        say "only camera images are missing: $(echo "$problem" | tail -n 1)"
}

if [ ! -x "$uv" ]; then install_uv; fi
if [ ! -x "$environment/bin/python" ]; then
    "$uv" venv --quiet --clear --python .venv/bin/python "$environment"
fi
lock=requirements/$name.txt
if [ "$name" != own ]; then  # `make add` wrote the hashes into own.txt
    lock=$environment/lock.txt
    .venv/bin/python tools/locks/complete.py "$name" > "$lock"
fi
say "installing $(grep -c == "$lock") packages of requirements/$name.txt into $environment"
# The lock is complete: nothing is resolved, nothing is compiled.
fetch "$uv" pip sync --quiet --python "$environment" --require-hashes --no-build "$lock"
case $name in aloha | cluster | dev | lerobot | metaworld | own | robosuite)
    "$uv" pip install --quiet --python "$environment" --no-deps --no-build-isolation \
        --editable .
    say "trying whether camera images can be drawn"
    provide_rendering
    ;;
esac
# Where Python may not keep what it compiles, every start would compile all of it.
if [ -n "${PYTHONDONTWRITEBYTECODE:-}" ]; then
    "$environment/bin/python" -W ignore -m compileall -q -j 0 "$environment/lib" conformance \
        reference_* > /dev/null || true
fi
touch "$environment/ready"
say "$environment is ready"
