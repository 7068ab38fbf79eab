#!/bin/sh
# Starts the builder that BUILDX_BUILDER names, unless it is there: builder.sh [DOCKER_CONTEXT]
set -eu
pins=$(dirname "$(readlink -f "$0")")/../tools/images.txt
if ! docker buildx inspect --bootstrap "$BUILDX_BUILDER" >/dev/null 2>&1; then
  image=$(grep -x 'moby/buildkit:.*@sha256:[0-9a-f]*' "$pins") || { echo "error: $pins has no moby/buildkit" >&2 && exit 1; }
  docker buildx create --bootstrap --name "$BUILDX_BUILDER" --driver docker-container \
    --driver-opt "image=$image" ${1+"$1"}
fi
