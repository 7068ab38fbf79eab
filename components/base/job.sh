#!/bin/bash -m
# Runs a command as a job in the foreground of the terminal, and ends as it does. What is typed then signals the command alone, and
# what reaches the entrypoint, which waits for this, comes from the engine.
SHLVL=$((SHLVL - 1)) # it counts the shells that somebody opens: not this one
exec {shown}>&2 2>/dev/null # bash would say how the command ended
"$@" 2>&"$shown" {shown}>&-
status=$?
while stopped=$(jobs -s) && [[ -n $stopped ]]; do # Ctrl-Z: there is no shell that could continue it
  fg >/dev/null
  status=$?
done
exit "$status"
