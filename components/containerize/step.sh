#!/bin/sh
# Starts a step of rosml on a base image, with these variables alone. Whoever made the image may have set others for its own programs,
# and they would change what tools of the step read, load or write: PERL5OPT, DPKG_ROOT, TAR_OPTIONS, LD_PRELOAD, BASH_ENV. Steps that
# run code of the packages do without this script: they have the image's variables.
#   step.sh COMMAND…
# IMAGE_ENVIRONMENT names the file with all variables of the image, for scripts of the repository (image_variables.sh).
set -eu
# The network, and where packages and rosdep's index come from; the ROS of the image; what compilers are told; arguments of the Dockerfiles.
for name in \
  PATH HTTP_PROXY HTTPS_PROXY FTP_PROXY ALL_PROXY NO_PROXY http_proxy https_proxy ftp_proxy all_proxy no_proxy \
  SSL_CERT_FILE SSL_CERT_DIR REQUESTS_CA_BUNDLE CURL_CA_BUNDLE PIP_CERT PIP_CONFIG_FILE PIP_CONSTRAINT PIP_INDEX_URL PIP_EXTRA_INDEX_URL \
  PIP_FIND_LINKS PIP_TRUSTED_HOST ROSDEP_SOURCE_PATH ROSDISTRO_INDEX_URL \
  ROS_DISTRO ROS_VERSION ROS_PYTHON_VERSION WORKSPACE \
  CC CXX CFLAGS CXXFLAGS CPPFLAGS LDFLAGS CUDA_HOME CUDACXX TORCH_CUDA_ARCH_LIST \
  CMAKE_ARGS COLCON_ARGS CONDITIONS MANIFESTS PYTHONHASHSEED ROSDEP_DAY SKIP_KEYS \
  ADOPTED BYTECODE DEBIAN_FRONTEND NUMPY PYTHON RMW_IMPLEMENTATION RUNTIME SCRIPT_SECRETS SOURCE_DATE_EPOCH TARGETARCH \
  ROS_APT_SOURCE ROS_ARCHIVE ROS_CHANNEL ROS_CODENAME ROS_COMPONENTS ROS_LIVE_ADDRESS ROS_PACKAGES ROS_ROW ROS_SIGNED_BY ROS_SNAPSHOT \
  ROS_SNAPSHOT_ADDRESS ROS_SYNC_DATE ROS_TESTING_ADDRESS ROS_TOOLS; do
  eval "[ -z \"\${$name+set}\" ] || set -- \"$name=\$$name\" \"\$@\""
done
# It stays until the command has ended: the file is that of this process.
/usr/bin/env -i HOME=/root LANG=C.UTF-8 "IMAGE_ENVIRONMENT=/proc/$$/environ" "$@" || exit
