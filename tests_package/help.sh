#!/usr/bin/env bash
# Each script at the top of the repository explains itself with --help, from any folder, and refuses what it does not
# know. It builds and installs nothing for that.
source "$SOURCE/tests_package/common.sh"
for script in bench demo docs package test; do
    said=$("$SOURCE/$script.sh" --help 2>&1) || fail "$script.sh --help ends with $?"
    grep -q "\./$script\.sh" <<<"$said" || fail "$script.sh --help says: $said"
    status=0
    "$SOURCE/$script.sh" --no-such-option >refused.txt 2>&1 || status=$?
    [ $status -eq 2 ] || fail "$script.sh --no-such-option ends with $status"
    grep -q usage refused.txt || fail "$script.sh --no-such-option says: $(<refused.txt)"
done
