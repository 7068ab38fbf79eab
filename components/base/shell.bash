# shellcheck shell=bash
# Sourced by every bash that starts interactively (/etc/bash.bashrc, and /root/.bashrc, where it was before) or as a login shell
# (/etc/profile.d): ROS and the workspaces, what completes ROS's commands, and a banner in the first shell (ROSML_BANNER=off: none).
if [[ -v _rosml_shell ]]; then return; fi
_rosml_shell=1
# shellcheck source=components/base/setup.bash
source /usr/local/share/rosml/setup.bash

if [[ $- == *i* ]]; then
  # ROS 1: roscd, rosed and their like are functions, so that each shell needs its own.
  # Debian has them among the completions, where they are loaded too late.
  for _rosml_file in "/opt/ros/${ROS_DISTRO-}/share/rosbash/rosbash" /usr/share/bash-completion/completions/rosbash; do
    # shellcheck disable=SC1090  # the paths are only known at run time
    if [[ -r $_rosml_file ]]; then source "$_rosml_file"; break; fi
  done
  unset _rosml_file

  # The scripts that complete these start Python: not before somebody asks. 124 has bash look again.
  _rosml_complete() {
    local file
    complete -r ros2 rosidl colcon vcs
    for file in "/opt/ros/${ROS_DISTRO-}"/share/{ros2cli,rosidl_cli,ament_index_python}/environment/*argcomplete.bash \
      /usr/share/colcon_argcomplete/hook/colcon-argcomplete.bash \
      /usr/share/vcstool-completion/vcs.bash /usr/share/bash-completion/completions/vcs.bash; do
      # shellcheck disable=SC1090
      if [[ -r $file ]]; then source "$file"; fi
    done
    return 124
  }
  complete -F _rosml_complete ros2 rosidl colcon vcs

  if [[ -x /usr/local/share/rosml/only-runs.sh ]] && ! declare -F command_not_found_handle >/dev/null; then
    command_not_found_handle() {
      printf '%s: %s: command not found\n' "$BASH" "$1" >&2
      /usr/local/share/rosml/only-runs.sh "$1"
      return 127
    }
  fi

  case ${ROSML_BANNER-} in
    off | no | false | 0) ;;
    *) if [[ -t 1 && ${SHLVL-1} -le 1 ]]; then /usr/local/share/rosml/banner.sh; fi ;;
  esac
fi
