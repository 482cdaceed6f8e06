#!/bin/sh
# Provides nginx and HAProxy, which tests/kit/test_behind_proxies.py runs a server behind.
# What the machine has is taken; on Debian and Ubuntu the packages are unpacked into
# .venv/proxies, where nothing of the machine changes and root is not needed. Elsewhere
# it names what to install, and fails: the tests do not pass without them.
set -eu
directory=.venv/proxies
if command -v nginx > /dev/null && command -v haproxy > /dev/null; then
    mkdir -p "$directory"
    touch "$directory/ready"
    exit
fi
if ! command -v apt-get > /dev/null || ! command -v dpkg-deb > /dev/null; then
    echo "set-up: nginx and haproxy are missing; install them" \
        "(macOS: brew install nginx haproxy)" >&2
    exit 1
fi
echo "set-up: unpacking nginx and haproxy into $directory"
rm -rf "$directory"
mkdir -p "$directory/lists/partial" "$directory/archives/partial"
here=$(pwd)/$directory
download() {
    apt-get -qq -y "$@" -o Debug::NoLocking=1 -o APT::Sandbox::User= \
        -o Dir::Cache::archives="$here/archives" --download-only \
        --no-install-recommends install nginx haproxy
}
own_lists="-o Dir::State::lists=$here/lists"
# The package lists may be missing or old, and only root may renew those of the machine.
download > "$directory/log" 2>&1 || {
    # shellcheck disable=SC2086 # one option of two words
    apt-get -qq $own_lists -o Debug::NoLocking=1 -o APT::Sandbox::User= update
    # shellcheck disable=SC2086
    download $own_lists
} >> "$directory/log" 2>&1 || {
    tail -n 3 "$directory/log" >&2
    echo "set-up: nginx and haproxy cannot be downloaded; install them" >&2
    exit 1
}
for package in "$directory"/archives/*.deb; do
    dpkg-deb --extract "$package" "$directory/root"
done
rm -rf "$directory/lists" "$directory/archives"
touch "$directory/ready"
