#!/bin/sh
# --units: tables in other units than SI, JSON in SI, and what is refused.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

