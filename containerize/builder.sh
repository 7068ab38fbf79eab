#!/bin/sh
# Starts the builder that BUILDX_BUILDER names, unless it is there: builder.sh [DOCKER_CONTEXT]
set -eu
pins=$(dirname "$(readlink -f "$0")")/../tools/go/buildkitd/go.mod
if ! docker buildx inspect --bootstrap "$BUILDX_BUILDER" >/dev/null 2>&1; then
  version=$(sed -n 's|^\tgithub.com/moby/buildkit \(v[0-9.]*\).*|\1|p' "$pins")
  docker buildx create --bootstrap --name "$BUILDX_BUILDER" --driver docker-container \
    --driver-opt "image=moby/buildkit:${version:?$pins has no version of buildkit}" ${1+"$1"}
fi
