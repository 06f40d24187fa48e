#!/usr/bin/env bash
# package/test_completion.sh FOLDER: checks the completions in the folder: what bash makes of the
# beginnings of words, and what zsh and fish, if installed, say about the syntax of theirs.
set -euo pipefail
folder=$1

# shellcheck disable=SC1091
source "$folder/completion.bash"

# expect WORDS EXPECTED...: these are the completions of the last of the words
expect()
{
  read -ra COMP_WORDS <<<"surface-mesh-foliation $1"
  [[ $1 != *' ' ]] || COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _surface_mesh_foliation || true # outside of a completion, compopt fails
  shift
  if [ "${COMPREPLY[*]:-}" != "$*" ]; then
    echo "after '${COMP_WORDS[*]}' bash offers '${COMPREPLY[*]:-}' instead of '$*'" >&2
    exit 1
  fi
}

expect "--wei" --weights
expect "mesh.off --height" --height --heights
expect "mesh.off --json --we" --weights # after an option without a value
expect "mesh.off --weights " mean-value cotangent
expect "mesh.off --weights c" cotangent
expect "mesh.off --parts " all largest
expect "mesh.off --height " # a number
expect "mes"                # left to bash
expect "--output /us" /usr
echo "bash: right"

if command -v zsh >/dev/null; then
  zsh -n "$folder/completion.zsh"
  echo "zsh: no errors"
fi
if command -v fish >/dev/null; then
  fish --no-execute "$folder/completion.fish"
  echo "fish: no errors"
fi
