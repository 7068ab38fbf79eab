# shellcheck shell=bash
# Sourced by build steps that download. A company's CA bundle comes in as a BuildKit secret: it is used for this
# step's own downloads and never becomes part of a layer.
ca_bundle=/run/secrets/ca-bundle
if [[ -s $ca_bundle ]]; then
  export SSL_CERT_FILE=$ca_bundle REQUESTS_CA_BUNDLE=$ca_bundle CURL_CA_BUNDLE=$ca_bundle PIP_CERT=$ca_bundle
fi

# A mirror of the distribution's own archive, below which each host is a folder: a secret as well, for arguments are part of
# the image's history.
os_mirror=$(cat /run/secrets/os-apt-mirror 2>/dev/null || true)
if [[ -n $os_mirror && ! $os_mirror =~ ^https?://[A-Za-z0-9._~:@/-]+$ ]]; then
  echo "error: OS_APT_MIRROR is not an address; set it to one such as http://host:3142, or unset it" >&2
  exit 1
fi

# Reads text and writes it with the addresses that this step asks: below a mirror, each host is a folder.
#   below MIRROR   if empty, the addresses stay
below() { if [[ -z $1 ]]; then cat; else sed -E "s#https?://#${1%/}/#g"; fi; }

# apt reads its settings from APT_CONFIG on top of the system's: retries for flaky mirrors, no prompts,
# nothing that is left in the image. https mirrors are checked against the same CA bundle.
APT_CONFIG=$(mktemp)
export APT_CONFIG DEBIAN_FRONTEND=noninteractive
export STEP_STARTED=${STEP_STARTED:-$(stat --format %y "$APT_CONFIG")} # for clean.sh
{
  echo 'Acquire::Retries "5";'
  echo 'Acquire::http::Timeout "60";'
  echo 'APT::Install-Recommends "false";'
  echo 'Dpkg::Use-Pty "false";'
  if [[ -s $ca_bundle ]]; then echo "Acquire::https::CAInfo \"$ca_bundle\";"; fi
} >"$APT_CONFIG"
trap 'rm -rf "$APT_CONFIG" "$APT_CONFIG.sources"' EXIT

# apt reads copies of its sources that name the mirror: the image keeps the official addresses.
if [[ -n $os_mirror ]]; then
  copies=$APT_CONFIG.sources
  mkdir -p "$copies/parts"
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    if [[ ! -f $file ]]; then continue; fi # a base image may have one or the other
    if [[ $file == /etc/apt/sources.list ]]; then copy=$copies/list; else copy=$copies/parts/${file##*/}; fi
    below "$os_mirror" <"$file" >"$copy"
  done
  printf 'Dir::Etc::%s "%s";\n' SourceList "$copies/list" SourceParts "$copies/parts" >>"$APT_CONFIG"
fi
