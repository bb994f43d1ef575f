#!/bin/sh
# Runs a command and writes what it took of the processor: clock.sh FILE COMMAND...
file=$1
shift
"$@" && times >"$file"
