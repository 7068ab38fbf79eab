#!/usr/bin/env bash
# Installs the apt source that ROS's packages come from, ROS's own or another, and asks it for its index once, so that what is
# wrong with it is said here.
#   ROS_CHANNEL     live: today's packages, set up by ROS's own package
#                   testing: packages before they are released into live, by the same key
#                   snapshot, final: a state of them, of a day or at the distribution's end of life
#   ROS_SNAPSHOT    day of the snapshot, such as 2026-08-07
#   ROS_LIVE_ADDRESS, ROS_TESTING_ADDRESS, ROS_SNAPSHOT_ADDRESS
#                   where these are, from matrix.yaml: http://host/ros2/ubuntu, http://host/jazzy/{day}/ubuntu
#   ROS_ARCHIVE     address of another archive, in the place of all that
#   ROS_COMPONENTS, ROS_SIGNED_BY  its components, and the file in archive-keys/ with the key that signs it, which
#                   is mounted as key.asc
#   ROS_VERSION     1 or 2
#   ROS_CODENAME    suite: of the operating system, such as noble, or of the other archive
#   ROS_SYNC_DATE   of when the source has to be, if that is said
#   ROS_APT_SOURCE  address and digest of a release of ros2-apt-source, for live: https://host/file.deb@sha256:…
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"
# shellcheck source=components/ros/apt.sh
source "$here/apt.sh"

if [[ $ROS_VERSION == 1 ]]; then generation=ros; else generation=ros2; fi
[[ -z ${ROS_ARCHIVE:-} ]] || ROS_CHANNEL=archive
case ${ROS_CHANNEL:?} in
  archive) address=$ROS_ARCHIVE ;;
  live) address=${ROS_LIVE_ADDRESS:?} ;;
  testing) address=${ROS_TESTING_ADDRESS:?} ;;
  snapshot) address=${ROS_SNAPSHOT_ADDRESS//"{day}"/${ROS_SNAPSHOT:?}} ;;
  final) address=${ROS_SNAPSHOT_ADDRESS//"{day}"/final} ;;
  *) fail "no channel '$ROS_CHANNEL'" "matrix.yaml knows live, testing, snapshot and final" ;;
esac

# The release file of ros-infrastructure/ros-apt-source, checked against the digest that matrix.yaml pins.
download() {
  local digest=${ROS_APT_SOURCE##*:} url pause status found
  url=$(below "$mirror" <<<"${ROS_APT_SOURCE%@*}")
  for pause in "${pauses[@]}"; do
    if status=$(curl --silent --show-error --location --fail --connect-timeout 30 --max-time 300 \
      --write-out '%{http_code}' --output "$1" "$url"); then
      found=$(sha256sum "$1" | cut -d ' ' -f 1)
      [[ $found == "$digest" ]] ||
        fail "$url has the sha256 $found, and not the pinned $digest" \
          "check the mirror, and if the release was made anew on purpose, pin its digest in apt_sources of matrix.yaml"
      return
    fi
    [[ $status != 404 ]] || fail "$url does not exist" "check apt_sources and codename in matrix.yaml, and the mirror"
    sleep "$pause"
  done
  fail "$url does not answer, after ${#pauses[@]} tries" \
    "check the network and HTTPS_PROXY, or name a mirror in ROS_APT_MIRROR"
}

# The key that a .sources file names, or holds itself: then its lines are indented, and empty ones are a point.
key_of() {
  local path
  path=$(sed -n 's/^Signed-By: *\(\/.*\)/\1/p' "$1")
  if [[ -n $path ]]; then cat "$path"; else sed -n '/BEGIN PGP/,/END PGP/{s/^Signed-By://;s/^ *//;s/^\.$//;p}' "$1"; fi
}

# The files that name the archive, or a repository or snapshot of ROS with the distribution, directly or below a mirror.
sources() {
  local snapshots=${ROS_SNAPSHOT_ADDRESS:-$address} live=${ROS_LIVE_ADDRESS:-$address}
  local testing=${ROS_TESTING_ADDRESS:-$live}
  snapshots=${snapshots%%"{day}"*}
  grep --files-with-matches -R -F -e "${live#*//}" -e "${testing#*//}" -e "${snapshots#*//}" /etc/apt/sources.list* ||
    [[ $? == 1 ]] # none does
}

codename=$(sed -n 's/^VERSION_CODENAME="\?\([a-z]*\).*/\1/p' /etc/os-release)
[[ $ROS_CHANNEL == archive || $codename == "${ROS_CODENAME:?}" ]] ||
  fail "the base image is '$codename', and matrix.yaml says '$ROS_CODENAME'" "check image, digest and codename there"
others=$(sources)
[[ -z $others ]] ||
  fail "the base image has an apt source of ROS already ($others)" "name an image without one in matrix.yaml"

if [[ $ROS_CHANNEL == live ]]; then
  [[ -n ${ROS_APT_SOURCE:-} ]] ||
    fail "no $generation-apt-source is pinned for $ROS_CODENAME" "add apt_sources to the operating system in matrix.yaml"
  package=$scratch/$generation-apt-source.deb
  download "$package"
  chmod 755 "$scratch" # apt reads it as another user
  apt_install "$package"
  file=$(dpkg --listfiles "$generation-apt-source" | grep '^/etc/apt/sources\.list\.d/')
  [[ $(key_of "$file" | fingerprint) == "$(fingerprint <"$keys/live.asc")" ]] ||
    fail "the pinned $generation-apt-source has another key than components/ros/keys/live.asc" \
      "put the key of that release there"
else
  if [[ $ROS_CHANNEL == archive ]]; then
    key=$here/../archive-keys/key.asc name=archive
    of=$(fingerprint <"$key" || true)
    [[ -n $of ]] ||
      fail "components/archive-keys/${ROS_SIGNED_BY:?} is no public key" "put the armored key there: gpg --armor --export KEY"
  elif [[ $ROS_CHANNEL == testing ]]; then
    key=$keys/live.asc name=testing
  else
    key=$keys/snapshots.asc name=snapshots
  fi
  keyring=/usr/share/keyrings/$generation-$name-keyring.asc
  install -D --mode=644 "$key" "$keyring"
  file=/etc/apt/sources.list.d/$generation-$name.sources
  printf '%s\n' 'Types: deb' "URIs: $address" "Suites: $ROS_CODENAME" "Components: ${ROS_COMPONENTS:-main}" \
    "Signed-By: $keyring" >"$file"
fi
for line in "URIs: $address" "Suites: $ROS_CODENAME"; do
  grep -q -x -F "$line" "$file" || fail "$file does not say '$line'" "check ros_archive, apt_sources and codename in matrix.yaml"
done

# The index of this source alone; its Release file says of which suite and of when it is.
mkdir "$scratch/only"
below "$mirror" <"$file" >"$scratch/only/ros.sources"
printf 'Dir::Etc::%s "%s";\n' SourceList /dev/null SourceParts "$scratch/only" >>"$APT_CONFIG"
apt_update
# When it is stands in the image's configuration, and not in its layers, which stay the same while no package changes.
require_sync "$address"

printf 'ros-%s %s\n' channel "$ROS_CHANNEL" source "$address" >>/usr/local/share/rosml/versions.d/ros
