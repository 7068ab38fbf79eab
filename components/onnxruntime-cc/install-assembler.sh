#!/usr/bin/env bash
# ONNX Runtime's headers, which no wheel has: those of Debian trixie's package libonnxruntime-dev 1.21.0, to
# /opt/onnxruntime-headers. They are an interface that newer libraries keep. Their content is pinned in headers.sha256, so
# an update of the package that leaves them as they are changes nothing here.
set -euo pipefail
release=trixie package=libonnxruntime-dev out=/opt/onnxruntime-headers

# shellcheck source=components/build/network.sh
source /run/components/build/network.sh

# shellcheck source=/dev/null
system=$(source /etc/os-release && echo "$ID")
if [[ $system != debian ]]; then
  echo "onnxruntime-cc: its headers come from Debian's archive, and the assembler's is $system's; name a system of Debian as the assembler in matrix.yaml" >&2
  exit 69
fi
# The archive, or its mirror, that this system's own apt asks first.
eval "$(apt-config shell list Dir::Etc::SourceList/f parts Dir::Etc::SourceParts/d)"
sources=$(cat "${list:?}" "${parts:?}"/* 2>/dev/null || true) # a base image may have one or the other
archive=$(grep -v '^ *#' <<<"$sources" | grep --only-matching -E '[a-z]+://[^] ]+' | sed -n 1p) || true
if [[ -z $archive ]]; then echo "onnxruntime-cc: apt's sources name no archive" >&2 && exit 69; fi

work=$(mktemp -d)
trap 'rm -rf "$APT_CONFIG" "$APT_CONFIG.sources" "$work"' EXIT
mkdir -p "$work/lists/partial"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $archive $release main" >"$work/sources.list"
# In settings that apt reads last: nothing of this stays in the assembler.
printf '%s "%s";\n' Dir::Etc::SourceList "$work/sources.list" Dir::Etc::SourceParts /dev/null Dir::State::Lists "$work/lists" \
  APT::Sandbox::User root >>"$APT_CONFIG"
apt-get update
(cd "$work" && apt-get download "$package")
dpkg-deb --extract "$work/$package"_*.deb "$work/files"
mkdir -p "$out"
cp -r "$work/files/usr/include/onnxruntime" "$out/include"
cp "$work/files/usr/share/doc/$package/copyright" "$out/copyright"
