#!/usr/bin/env bash
# test/debian_mirror.sh: prints the mirror of Debian that this system installs its packages from.
set -euo pipefail
# shellcheck disable=SC2016
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Identifier: Packages' 'Origin: Debian' \
  'Codename: bookworm' | head -n 1)
echo "${mirror:-http://deb.debian.org/debian}"
