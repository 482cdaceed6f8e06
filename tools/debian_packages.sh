#!/bin/sh
# Installs packages of Debian or Ubuntu: `sh tools/debian_packages.sh WHY NAME...`.
# Only root may: for others, and on other systems, it ends with 1 and says nothing, because
# the caller knows what is missing and says so.
set -eu
why=$1
shift
if [ "$(id -u)" != 0 ] || ! command -v apt-get > /dev/null; then exit 1; fi
echo "set-up: installing $* $why"
export DEBIAN_FRONTEND=noninteractive
apt="apt-get -qq -y -o Dpkg::Use-Pty=0 install --no-install-recommends"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# The package lists may be missing or old.
$apt "$@" > "$log" 2>&1 || { apt-get -qq update && $apt "$@"; } >> "$log" 2>&1 || {
    tail -n 3 "$log" >&2
    exit 1
}
