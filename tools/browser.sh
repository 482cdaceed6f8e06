#!/bin/sh
# Provides Chromium, in which tests look at the pages of a server.
# What the machine has is taken; root on Debian and Ubuntu installs the package. Elsewhere
# it names what to install, and fails: the tests do not pass without it.
set -eu
for name in chromium chromium-browser google-chrome; do
    if command -v "$name" > /dev/null; then exit; fi
done
if [ "$(id -u)" != 0 ] || ! command -v apt-get > /dev/null; then
    echo "set-up: Chromium is missing; install it" \
        "(Debian: apt-get install chromium; macOS: brew install chromium)" >&2
    exit 1
fi
echo "set-up: installing chromium, in which pages are tested"
export DEBIAN_FRONTEND=noninteractive
apt="apt-get -qq -y -o Dpkg::Use-Pty=0 install --no-install-recommends"
log=.venv/browser.log
# The package lists may be missing or old.
$apt chromium > "$log" 2>&1 || { apt-get -qq update && $apt chromium; } >> "$log" 2>&1 || {
    tail -n 3 "$log" >&2
    echo "set-up: chromium cannot be installed; install it" >&2
    exit 1
}
