# shellcheck shell=bash
# Completes make in this checkout, from the files that are there: source tools/completion.bash
# Commands; and names after TARGET=, GROUP=, ONLY= and STACK=. Elsewhere, make is completed as before.
_rosml_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
_rosml_before=$(complete -p make 2>/dev/null | sed -n 's/.*-F \([^ ]*\).*/\1/p') || true

_rosml_names() { # all names of one kind
  case $1 in
    commands) sed -n 's/^\([a-z0-9-]*\):.*## .*/\1/p' "$_rosml_root/Makefile" ;;
    TARGET) sed -n 's/^target "\([a-z0-9][^"]*\)".*/\1/p' "$_rosml_root/docker-bake.hcl" | grep -v -e '-test$' -e '^payload-' -e '^file-list$' ;;
    ONLY) _rosml_names TARGET && _rosml_names GROUP ;;
    GROUP) sed -n 's/^group "\([a-z0-9][^"]*\)".*/\1/p' "$_rosml_root/docker-bake.hcl" | grep -v -e '-test$' -e '^default$' ;;
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
