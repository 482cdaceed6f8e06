#!/bin/sh
# Provides Chromium, in which tests look at the pages of a server.
# What the machine has is taken; root on Debian and Ubuntu installs the package. Elsewhere
# it names what to install, and fails: the tests do not pass without it.
set -eu
for name in chromium chromium-browser google-chrome; do
    if command -v "$name" > /dev/null; then exit; fi
done
sh tools/debian_packages.sh "in which pages are tested" chromium || {
    echo "set-up: Chromium is missing; install it" \
        "(Debian: apt-get install chromium; macOS: brew install chromium)" >&2
    exit 1
}
