#!/bin/sh
# Resolves requirements/*.in into hashed locks for every platform: `make lock`. Versions
# that are locked stay; ARGS=--upgrade takes the newest. `kit`, `client`, `server`,
# `generate` and `cluster` take the versions of `dev`; `metaworld`, `aloha` and `robosuite`
# need another MuJoCo, `lerobot` has torch and `bench` has the peers, so they are resolved
# alone. A lock names no index, no path and no machine.
set -eu
uv=$PWD/.venv/bin/uv
# A machine's own index or folder of wheels must not decide which hashes are locked.
unset $(env | sed -n 's/^\(UV_[A-Z_]*\)=.*/\1/p')
cd requirements

lock() {
    name=$1
    shift
    # No compiler is needed to install: a package without wheels is an error.
    "$uv" pip compile --quiet --no-config --no-header --universal \
        --python-version 3.11 --generate-hashes --only-binary :all: \
        --no-emit-index-url --no-emit-find-links \
        "$name.in" --output-file "$name.txt" "$@" > /dev/null
    echo "requirements/$name.txt: $(grep -c == "$name.txt") packages"
}

lock dev "$@"
lock kit --constraints dev.txt "$@"
lock client --constraints dev.txt "$@"
lock server --constraints dev.txt "$@"
lock generate --constraints dev.txt "$@"
lock cluster --constraints dev.txt "$@"
lock metaworld --overrides metaworld-overrides.txt "$@"
lock aloha --overrides aloha-overrides.txt "$@"
lock robosuite --overrides robosuite-overrides.txt "$@"
lock lerobot --excludes lerobot-excludes.txt "$@"
lock bench "$@"
lock site "$@"
