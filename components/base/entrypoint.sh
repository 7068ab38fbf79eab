#!/bin/bash
# Sources ROS and the workspaces, then becomes the command; as the user DOCKER_UID:DOCKER_GID where both are given.
# Runs before every command: nothing slow, no output, no fork that is not needed.

for setup in "/opt/ros/${ROS_DISTRO}/setup.bash" \
  /opt/ws_base_image/install/setup.bash \
  "${WORKSPACE}/devel/setup.bash" "${WORKSPACE}/install/setup.bash"; do
  # shellcheck disable=SC1090  # the paths are only known at run time
  if [[ -r $setup ]]; then source "$setup" ""; fi
done
unset setup

[[ $# -gt 0 ]] || set -- bash

if [[ -n ${DOCKER_UID}${DOCKER_GID} && (-z ${DOCKER_UID} || -z ${DOCKER_GID}) ]]; then
  echo "entrypoint: DOCKER_UID and DOCKER_GID only work together; running as $(id -un)" >&2
fi

# Without both variables, as another user than root, or for root itself there is nobody to become.
if [[ -z ${DOCKER_UID} || -z ${DOCKER_GID} || ${EUID} -ne 0 || ${DOCKER_UID} == 0 ]]; then
  exec "$@"
fi

if [[ ! ${DOCKER_UID} =~ ^[0-9]+$ || ! ${DOCKER_GID} =~ ^[0-9]+$ ]]; then
  echo "entrypoint: DOCKER_UID and DOCKER_GID take numbers, not '${DOCKER_UID}' and '${DOCKER_GID}'" >&2
  exit 64
fi

user=${DOCKER_USER:-dockeruser}
# A read-only root has no room for a new user: run as the bare ids instead.
if [[ ! -w /etc/passwd ]]; then exec gosu "${DOCKER_UID}:${DOCKER_GID}" "$@"; fi

if ! getent group "${DOCKER_GID}" >/dev/null; then groupadd --gid "${DOCKER_GID}" "${user}"; fi
if existing=$(getent passwd "${DOCKER_UID}"); then
  user=${existing%%:*}
  usermod --gid "${DOCKER_GID}" --append --groups sudo,video "${user}"
else
  useradd --uid "${DOCKER_UID}" --gid "${DOCKER_GID}" --groups sudo,video \
    --shell /bin/bash --create-home "${user}"
fi
home=$(getent passwd "${user}" | cut -d: -f6)
if [[ -n ${WORKSPACE} && -d ${WORKSPACE} && ! -e ${home}/ws ]]; then ln -s "${WORKSPACE}" "${home}/ws"; fi

# gosu by name, so that the supplementary groups are set; HOME follows the user.
export HOME=${home}
exec gosu "${user}" "$@"
