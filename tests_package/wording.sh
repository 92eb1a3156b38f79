#!/usr/bin/env bash
# Phrases that a reader had to guess at do not come back, in what users read: documents, the header, packages, examples
# and messages.
source "$SOURCE/tests_package/common.sh"

phrases='stands? in|can stand in|stands? twice|looks? around in|has none but|to be had|caller.s hold|need your lock'
phrases+='|guess of the processor|nothing to do with (one another|each other)|famil(y|ies) of chains'
cd "$SOURCE"
for folder in include src docs bindings cmake examples packaging; do
    [ -d "$folder" ] || fail "there is no folder $folder"
done
expect_no_match "unclear phrases" -rnwEi --exclude-dir={node_modules,target,build,images} --exclude='released_*' -I "$phrases" \
    include src docs bindings cmake examples packaging *.md *.sh
