#!/usr/bin/env bash
# ping works for root and for every other user, and starts in a container without NET_RAW.
set -euo pipefail
reach() { "$@" ping -c 1 -W 5 127.0.0.1 >/dev/null || { echo "ping fails: $*" >&2; exit 1; }; }
reach env
reach setpriv --reuid=65534 --regid=65534 --clear-groups
# Whether it may open a socket then is up to the engine (net.ipv4.ping_group_range), and not to the image.
setpriv --bounding-set=-net_raw --inh-caps=-net_raw ping -V >/dev/null || { echo "ping does not start without NET_RAW" >&2; exit 1; }
