# shellcheck shell=bash
# Sourced by build steps that download. A company's CA bundle comes in as a BuildKit secret: it is used for this
# step's own downloads and never becomes part of a layer.
ca_bundle=/run/secrets/ca-bundle
if [[ -s $ca_bundle ]]; then
  export SSL_CERT_FILE=$ca_bundle REQUESTS_CA_BUNDLE=$ca_bundle CURL_CA_BUNDLE=$ca_bundle PIP_CERT=$ca_bundle
fi

# apt reads its settings from APT_CONFIG on top of the system's: retries for flaky mirrors, no prompts,
# nothing that is left in the image. https mirrors are checked against the same CA bundle.
APT_CONFIG=$(mktemp)
export APT_CONFIG DEBIAN_FRONTEND=noninteractive
{
  echo 'Acquire::Retries "5";'
  echo 'Acquire::http::Timeout "60";'
  echo 'APT::Install-Recommends "false";'
  echo 'Dpkg::Use-Pty "false";'
  if [[ -s $ca_bundle ]]; then echo "Acquire::https::CAInfo \"$ca_bundle\";"; fi
} >"$APT_CONFIG"
trap 'rm -f "$APT_CONFIG"' EXIT
