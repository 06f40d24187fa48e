#!/usr/bin/env bash
# test/install_packages.sh PURPOSE...: installs those of the Debian packages for these purposes
# (test/packages.txt) that are missing.
set -euo pipefail
list=$(dirname "$0")/packages.txt

missing=()
for purpose in "$@"; do
  packages=$(sed -n "s/^$purpose: *//p" "$list")
  [ -n "$packages" ] || { echo "$list does not know the purpose '$purpose'" >&2; exit 1; }
  for package in $packages; do
    # Node.js from elsewhere brings its own npm, which Debian's package would conflict with.
    [ "$package" = npm ] && [ -n "$(type -P npm)" ] && continue
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing+=("$package")
  done
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null </dev/null
