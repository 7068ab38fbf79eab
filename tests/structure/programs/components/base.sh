# shellcheck shell=bash
# base: a nodelet manager starts and offers its services; an action is asked for and done.
: "${here:?}" "${work:?}" # of run.sh
rosrun nodelet nodelet manager __name:=manager >"$work/manager.log" 2>&1 &
until_it_answers rosservice call /manager/list
timeout 120 python3 "$here/action.py"
