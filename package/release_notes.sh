#!/usr/bin/env bash
# package/release_notes.sh: prints what CHANGES.md says about the latest release.
set -euo pipefail
notes=$(awk '/^## Release /{ if (++count > 1) exit } count == 1' "$(dirname "$0")/../CHANGES.md")
[ -n "$notes" ] || { echo "CHANGES.md has no release" >&2; exit 1; }
printf '%s\n' "$notes"
