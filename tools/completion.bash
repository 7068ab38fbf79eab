# shellcheck shell=bash
# Completes make in this checkout, from the files that are there: source tools/completion.bash
# Commands; and names after TARGET=, GROUP=, ONLY= and STACK=. Elsewhere, make is completed as before.
_rosml_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
_rosml_before=$(complete -p make 2>/dev/null | sed -n 's/.*-F \([^ ]*\).*/\1/p') || true

# The rows of docker-bake.hcl -> each component alone, and with each framework on each stack.
# shellcheck disable=SC2016 # it is awk that expands these
_rosml_targets='
  /^  [a-z0-9-]+ = [{]$/ { row = $1; count = 0 }
  /^    packages = / {
    while (match($0, /[a-z0-9-]+ = "/)) {
      component[++count] = substr($0, RSTART, RLENGTH - 4)
      print row "-" component[count]
      $0 = substr($0, RSTART + RLENGTH)
    }
  }
  /^    stacks = / && count {
    while (match($0, /[a-z0-9-]+ = \[[^]]*/)) {
      split(substr($0, RSTART, RLENGTH), word, /[^a-z0-9-]+/) # a framework, then its stacks
      for (i = 2; word[i] != ""; i++)
        for (n = 1; n <= count; n++) print row "-" component[n] "-" word[1] "-" word[i]
      $0 = substr($0, RSTART + RLENGTH)
    }
  }
'

_rosml_names() { # all names of one kind
  case $1 in
    commands) sed -n 's/^\([a-z0-9-]*\):.*## .*/\1/p' "$_rosml_root/Makefile" ;;
    TARGET) awk "$_rosml_targets" "$_rosml_root/docker-bake.hcl" ;;
    ONLY) _rosml_names TARGET && _rosml_names GROUP ;;
    GROUP) sed -n 's/^group "\([a-z0-9][^"]*\)".*/\1/p' "$_rosml_root/docker-bake.hcl" | grep -v '^default$' ;;
    STACK) (cd "$_rosml_root/locks" && ls) ;;
  esac
}

_rosml_make() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} kind=commands
  if [[ $PWD != "$_rosml_root" ]]; then
    if [[ -n $_rosml_before ]]; then "$_rosml_before" "$@"; fi
    return
  fi
  if [[ $word == '=' ]]; then # readline splits words there
    kind=$before word=
  elif [[ $before == '=' ]]; then
    kind=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  mapfile -t COMPREPLY < <(compgen -W "$(_rosml_names "$kind")" -- "$word")
}
complete -o default -F _rosml_make make
