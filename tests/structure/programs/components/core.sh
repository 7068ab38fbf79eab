# shellcheck shell=bash
# core: nodes, topics, parameters and services are told of.
# The master answers before /rosout has told it that it is there.
until_it_answers bash -c 'rosnode list | grep --quiet --line-regexp /rosout'
rosnode list | grep -x /rosout
rosparam set /number 7 && [[ $(rosparam get /number) == 7 ]]
rosservice list | grep -x /rosout/get_loggers
rosmsg show std_msgs/String
