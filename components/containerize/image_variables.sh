# shellcheck shell=bash
# Sourced before a script of the repository runs in a step: it has the variables of the image, which step.sh left out, and those that
# the step set.
while IFS= read -r -d '' variable; do
  name=${variable%%=*}
  if [[ $name =~ ^[A-Za-z_][A-Za-z0-9_]*$ && (-z ${!name+set} || $name == HOME || $name == LANG) ]]; then export "${variable?}"; fi
done <"$IMAGE_ENVIRONMENT"
unset variable name
