#!/bin/bash
# Becomes the user DOCKER_UID:DOCKER_GID where both are given; then sources ROS and the workspaces, and becomes the command. Below
# tini, as the container's own, it does that in a child, and attends it: a stop reaches this process alone.
# Runs before every command: nothing slow, no output, no fork that is not needed.

fail() {
  echo "entrypoint: $1; $2" >&2
  exit "$3"
}

# become COMMAND…: as the user uid:gid, with what was given as --group-add besides the user's own groups.
become() {
  local group fd others="" ids=(--reuid="$uid" --regid="$gid" --clear-groups)
  for group in $(id --groups) $(id --groups "$user" 2>/dev/null); do
    if [[ $group -ne 0 ]]; then others+=,$group; fi
  done
  if [[ -n $others ]]; then ids[2]=--groups=${others#,}; fi
  # What the engine attached belongs to whoever started it: /dev/stdout could not be opened.
  for fd in 0 1 2; do
    if [[ -p /proc/self/fd/$fd || -t $fd ]]; then chown "$uid" "/proc/self/fd/$fd"; fi
  done
  export HOME=$home USER=$user LOGNAME=$user
  exec setpriv "${ids[@]}" -- "$0" "$@"
}

# ordinary FOLDER: sets $folder to where it is, behind all links. Fails for a folder of the system, and for one that is not there.
ordinary() {
  folder=$(realpath --canonicalize-existing -- "$1" 2>/dev/null) || return 1
  case $folder/ in
    // | /home/ | /opt/ | /srv/ | /mnt/ | /media/ | /tmp/) return 1 ;;
    /bin/* | /boot/* | /dev/* | /etc/* | /lib/* | /lib32/* | /lib64/* | /libx32/* | /proc/* | /root/* | /run/*) return 1 ;;
    /sbin/* | /sys/* | /usr/* | /var/*) return 1 ;;
  esac
}

# give FOLDER: it becomes the user's, with all in it that is root's. Whatever is mounted keeps its owner, and folders of the
# system do, whatever link of an image leads there.
give() {
  local errors folder point skipped=()
  ordinary "$1" || return 0
  while read -r _ _ _ _ point _; do
    printf -v point %b "$point" # a space is \040 there
    if [[ $point != / && $folder/ == "${point%/}"/* ]]; then return; fi
    if [[ $point == "$folder"/* ]]; then
      point=${point//\\/\\\\} point=${point//\*/\\*} point=${point//\?/\\?} point=${point//\[/\\[} # find takes a pattern
      skipped+=(-path "$point" -prune -o)
    fi
  done </proc/self/mountinfo
  errors=$(LC_ALL=C find "$folder" -ignore_readdir_race -xdev "${skipped[@]}" -user 0 \
    -exec chown --no-dereference "$uid:$gid" {} + 2>&1) && return
  # Others may work there, since docker exec comes here as well: what is gone by now needs no owner.
  if grep --invert-match ': No such file or directory$' <<<"$errors" >&2; then
    fail "cannot give $folder to the user $user" "the line above says why" 71
  fi
}

# give_workspace: the user owns it, and finds it as ~/ws, if the home is the container's own: nothing is left in a mounted one.
give_workspace() {
  local folder
  ordinary "${WORKSPACE:-/docker-ros/ws}" || return 0
  if [[ ! -e $home/ws && ! -L $home/ws && $home/ != "$folder"/* && -w $home && $(stat --format %d "$home") == $(stat --format %d /) ]]; then
    ln --symbolic "$folder" "$home/ws"
    chown --no-dereference "$uid:$gid" "$home/ws"
  fi
  give "$folder"
}

# give_home: a folder with what a new user has. Where something is mounted below it, the engine made it, for root. One that is
# mounted itself stays as it is. One that is a link to a folder of the system is nobody's home.
give_home() {
  local file folder
  if [[ -d $home && $(stat --format %u "$home") -eq $uid ]] || mountpoint --quiet "$home"; then return; fi
  mkdir --parents "$home" || fail "cannot make a home for the user $user" "the line above says why" 71
  if ! ordinary "$home"; then
    home=/tmp
    return
  fi
  for file in /etc/skel/.[!.]* /etc/skel/*; do
    if [[ -e $file && ! -e $home/${file##*/} ]]; then cp --recursive "$file" "$home"; fi
  done
  give "$home"
}

# make_user: the user with that uid is there, with a home of their own and the groups sudo and video.
make_user() {
  local existing key capabilities group groups create=--create-home changes=()
  while read -r key capabilities; do
    # CHOWN, DAC_OVERRIDE, FOWNER, SETGID, SETUID: linux/capability.h
    if [[ $key == CapEff: ]] && (((16#$capabilities & 0xcb) != 0xcb)); then
      fail "without CHOWN, DAC_OVERRIDE, FOWNER, SETGID and SETUID nobody can become another user" \
        "add these capabilities, or use docker run --user" 71
    fi
  done </proc/self/status

  if ! getent group "$gid" >/dev/null; then
    group=$user
    if getent group "$group" >/dev/null; then group=$user-$gid; fi
    groupadd --gid "$gid" "$group" || fail "cannot make a group $gid" "the line above says why" 71
  fi
  if existing=$(getent passwd "$uid"); then
    IFS=: read -r user _ _ group _ home _ <<<"$existing"
    if [[ ! -d $home || $(stat --format %u "$home") -ne $uid ]]; then # none, or a folder of the system
      home=/home/$user
      give_home
      changes+=(--home "$home")
    fi
    groups=" $(id --groups --name "$user") "
    if [[ $group -ne $gid ]]; then changes+=(--gid "$gid"); fi
    if [[ $groups != *" sudo "* || $groups != *" video "* ]]; then changes+=(--append --groups "sudo,video"); fi
    if [[ ${#changes[@]} -gt 0 ]]; then
      usermod "${changes[@]}" "$user" || fail "cannot use the user $user, whose uid is $uid" "the line above says why" 71
    fi
  else
    home=/home/$user
    ! getent passwd "$user" >/dev/null || fail "the user name $user is taken" "choose another one with DOCKER_USER" 64
    if [[ -e $home ]]; then create=--no-create-home; fi
    useradd --uid "$uid" --gid "$gid" --groups sudo,video --shell /bin/bash --home-dir "$home" $create \
      --key UID_MIN=1 --key UID_MAX=4294967294 "$user" || # it warns of others than those that it gives by itself
      fail "cannot make the user $user with the uid $uid" "the line above says why" 71
    give_home
  fi
}

# attend COMMAND…: starts it, hands signals on to it, and ends as it does. SIGTERM and SIGINT go to all that runs, by stop.py; then
# this ends after all of it has ended.
attend() {
  local child number asked=0 interrupted stopping="" status words=() command=("$0" "$@")
  if [[ $PPID -eq 1 ]]; then words+=(all); fi
  if has_terminal; then
    words+=(terminal)
    command=(/usr/local/share/rosml/job.sh "${command[@]}")
  fi
  # In the background, they would be ignored. SHLVL counts the shells that somebody opens: not this one.
  (trap - INT QUIT && SHLVL=$((SHLVL - 1)) && exec -- "${command[@]}") <&0 &
  child=$!
  for number in {1..31} {34..64}; do
    # shellcheck disable=SC2064  # that number
    case $number in
      # KILL, CHLD, STOP, TTIN, TTOU; CONT, which timeout and systemd send right after SIGTERM: of two signals that arrive at
      # once, bash's wait loses one.
      9 | 17 | 18 | 19 | 21 | 22) ;;
      *) trap "interrupted=1; signalled $number" "$number" ;;
    esac
  done
  exec 2>/dev/null # bash would say how the command ended
  await "$child"
  status=$?
  if [[ -n $stopping ]]; then await "$stopping"; fi
  exit "$status"
}

# signalled NUMBER: hands a signal on. Nobody gets a second SIGTERM while they save.
signalled() {
  local main=$child
  case $1 in
    2 | 15)
      if [[ $asked -eq 15 ]]; then return; fi
      if [[ -n $stopping ]]; then kill "$stopping"; fi
      asked=$1
      /usr/bin/python3 -I -S /usr/local/share/rosml/stop.py "$1" "$child" "${words[@]}" &
      stopping=$!
      ;;
    *)
      if [[ " ${words[*]} " == *" terminal "* ]]; then read -r main _ <"/proc/$child/task/$child/children"; fi
      kill -s "$1" "$main"
      ;;
  esac
}

# await PROCESS: waits until it has ended, whatever signals come meanwhile; returns its status.
await() {
  local status
  while
    interrupted=
    wait "$1"
    status=$?
    [[ -n $interrupted ]]
  do :; done
  return "$status"
}

# has_terminal: whether what is typed reaches us, with signals such as that of Ctrl-C.
has_terminal() {
  local group foreground
  read -r _ _ _ _ group _ _ foreground _ <"/proc/$$/stat"
  [[ $group -eq $foreground ]]
}

# ---- As root, for somebody else: nothing but the image's own files is read before the user is changed ----------------
if [[ $EUID -eq 0 && -n $DOCKER_UID && -n $DOCKER_GID ]]; then
  for number in "$DOCKER_UID" "$DOCKER_GID"; do
    # ids end at 2^32 - 2; beyond that bash's own arithmetic would wrap around
    if [[ ! $number =~ ^0*[0-9]{1,10}$ ]] || ((10#$number > 4294967294)); then
      fail "DOCKER_UID and DOCKER_GID take numbers, not '$DOCKER_UID' and '$DOCKER_GID'" "id -u and id -g give them" 64
    fi
  done
  uid=$((10#$DOCKER_UID)) gid=$((10#$DOCKER_GID)) user=${DOCKER_USER:-dockeruser} home=/tmp
  # Debian's useradd would take ../../etc, and other programs a number for an id.
  [[ $user =~ ^[A-Za-z_][A-Za-z0-9_.-]{0,31}$ ]] ||
    fail "DOCKER_USER is no user name: '$user'" "take letters, digits, points, hyphens and underscores" 64
  if [[ $uid -ne 0 ]]; then
    # A read-only root has no room for a new user: the bare ids, and /tmp for a home.
    if [[ -w /etc/passwd ]]; then
      exec {lock}</etc && flock "$lock" # docker exec comes here as well: of several at once, the first makes the user
      make_user
      give_workspace
      exec {lock}<&-
    fi
    become "$@"
  fi
fi

# ---- As whoever runs the command -------------------------------------------------------------------------------------
if [[ -r /proc/$PPID/comm && -x /usr/bin/python3 ]] && read -r _rosml_parent </proc/$PPID/comm; then
  case $_rosml_parent in tini* | docker-init | catatonit) attend "$@" ;; esac
fi
unset _rosml_parent
if [[ $EUID -eq 0 && -n $DOCKER_UID$DOCKER_GID && (-z $DOCKER_UID || -z $DOCKER_GID) ]]; then
  echo "entrypoint: DOCKER_UID and DOCKER_GID only work together; running as root" >&2
elif [[ $EUID -ne 0 && -n ${DOCKER_UID-} && $DOCKER_UID != "$EUID" ]]; then
  echo "entrypoint: DOCKER_UID has no effect, since the container started as uid $EUID; docker run --user root makes it count" >&2
fi
if [[ $EUID -ne 0 && ! -w ${HOME:-/} && -w /tmp ]]; then
  # A user without an entry (--user 12345:0) has / for a home, where ROS cannot write its logs.
  export HOME=/tmp
fi

# Launch files read USER, and Python's getpass takes it for the name of an id that has none.
if [[ -z ${USER-} ]]; then
  _rosml_user='\u'
  USER=${_rosml_user@P}
  if [[ $USER == "I have no name!" ]]; then USER=${DOCKER_USER:-dockeruser}; fi
  export USER LOGNAME=$USER
  unset _rosml_user
fi

# What is sourced may change our arguments and options, and may end this shell: that must not pass for the command.
readonly _rosml_command=("$@") _rosml_folder=$PWD
ended() {
  echo "entrypoint: ${_rosml_setup:-a setup file} ended the shell (exit status $1), nothing was started;" \
    "mend it, or start past it with --entrypoint bash" >&2
  exit 70
}
trap 'ended $?' EXIT
trap 'trap - EXIT; exit 130' INT
trap 'trap - EXIT; exit 143' TERM
# shellcheck source=components/base/setup.bash
source /usr/local/share/rosml/setup.bash
builtin trap - EXIT DEBUG ERR RETURN HUP INT QUIT TERM
builtin set +aefuxET
builtin shopt -u expand_aliases
builtin unset -f exec cd
unset IFS
if [[ $PWD != "$_rosml_folder" ]]; then cd -- "$_rosml_folder" || exit 70; fi
if [[ ${#_rosml_command[@]} -eq 0 ]]; then exec bash; fi
if ! type -P -- "${_rosml_command[0]}" >/dev/null; then
  if [[ ${_rosml_command[0]} == *" "* && ! -e ${_rosml_command[0]} ]]; then
    echo "entrypoint: no program is called '${_rosml_command[0]}'; leave out the quotes, or write bash -c before them" >&2
    exit 127
  fi
  if [[ -x /usr/local/share/rosml/only-runs.sh ]]; then /usr/local/share/rosml/only-runs.sh "${_rosml_command[0]}"; fi
fi
exec -- "${_rosml_command[@]}"
