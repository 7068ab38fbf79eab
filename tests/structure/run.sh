#!/usr/bin/env bash
# Runs structure tests (mounted at /run/tests) on the root file system that it stands in (a RUN step on top of the image).
#   run.sh REPORT_FOLDER
#   TESTS         names of the test files beside this script, separated by spaces
#   EXPECT        what the tag and the labels promise, as name=value pairs; tests read it as $EXPECT_NAME
# Writes one JSON report per file and, if anything failed, a file `failed` that says what. Exits 0 even then, so that
# the report can be taken out of the build; the stage after this one fails.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
report=$1
mkdir -p "$report"

for pair in ${EXPECT:-}; do
  name=${pair%%=*}
  name=${name//-/_}
  export "EXPECT_${name^^}=${pair#*=}"
done
# What the builder passes to build steps is not the image's: tests must not see it.
unset http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY
unset CHECK_ROOT # for a made-up root, in tests of the checks themselves

read -ra names <<<"${TESTS:?}"
metadata=$report/config.json
if [[ -s /run/metadata/config.json ]]; then
  names+=(metadata)
  cp /run/metadata/config.json /run/metadata/metadata.yaml "$report/"
else
  echo "metadata: not tested: no image config at hand (make image passes the published one)"
  echo '{}' >"$metadata" # the host driver insists on a file
fi

config_of() { if [[ $1 == metadata ]]; then echo "$report/metadata.yaml"; else echo "$here/$1.yaml"; fi; }
export -f config_of
export here report metadata

run_one() {
  local name=$1 config
  config=$(config_of "$name")
  echo "$name"
  /run/structure-test/container_structure_test/bin/container-structure-test test --driver host --force --output json \
    --test-report "$report/$name.json" --metadata "$metadata" --config "$config" >"$report/$name.log" 2>&1 ||
    true # summary.py judges, and takes a missing report for a failure
}
export -f run_one

# Files run on one root, as many at a time as there are processors, the child's own (the long ones) first. So each has ports and
# folders of its own, and makes users by the entrypoint alone, which has a lock. pip changes Python's packages for a moment: it comes when
# nobody imports them any more.
for name in "${names[@]}"; do
  if [[ $name != pip ]]; then echo "$name"; fi
done | tac | xargs --max-procs "$(nproc)" -I NAME bash -c 'run_one NAME'
if [[ " ${names[*]} " == *' pip '* ]]; then run_one pip; fi

python3 "$here/summary.py" "$report" "${names[@]}"

# The versions of what is inside, as its parts recorded them; the publisher compares architectures by them.
cat /usr/local/share/rosml/versions.d/* >"$report/versions" 2>/dev/null || true

# The image's size: what the tests left is not part of it.
du --summarize --one-file-system --block-size=1K --exclude="$report" / >"$report/unpacked"
