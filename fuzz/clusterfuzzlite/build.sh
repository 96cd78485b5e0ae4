#!/bin/bash -eu
exec bash "$SRC/osteon/fuzz/build.sh"
