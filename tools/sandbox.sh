#!/bin/sh
# Provides bubblewrap, in which tests/platform/ runs policies that are not trusted.
# What the machine has is taken; root on Debian and Ubuntu installs the package. Elsewhere
# it names what to install, and fails: the tests do not pass without it.
set -eu
if command -v bwrap > /dev/null; then exit; fi
sh tools/debian_packages.sh "in which submissions are run" bubblewrap || {
    echo "set-up: bubblewrap is missing; install it" \
        "(Debian: apt-get install bubblewrap; it needs Linux)" >&2
    exit 1
}
