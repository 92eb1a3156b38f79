#!/usr/bin/env bash
# The Go module as a zip with the archive of the library inside: unzip it and lead your go.mod there by "replace".
source "$(dirname "$0")/common.sh"
native_library

system=$(go env GOOS)_$(go env GOARCH)
module=gamephys@v$version
cp -r "$SOURCE/bindings/go" "$module"
rm -f "$module/readme.sh"
mkdir -p "$module/native/$system" "$module/native/include"
cp "$SOURCE/LICENSE" "$module"
cp "$SOURCE/include/gamephys_c.h" "$module/native/include"
cp "$native/lib/libgamephys.a" "$module/native/$system"
cat >"$module/library.go" <<END
package gamephys

// #cgo CFLAGS: -I\${SRCDIR}/native/include
// #cgo LDFLAGS: \${SRCDIR}/native/$system/libgamephys.a -lstdc++ -lm -pthread
import "C"
END
sed -i 's|^#cgo pkg-config: gamephys$|#cgo CFLAGS: -I${SRCDIR}/../../native/include|' "$module/internal/ration/ration.go"
rm -f "$PACKAGES"/gamephys@*.zip
python3 -m zipfile -c "$PACKAGES/gamephys@v$version-$system.zip" "$module"

python3 -m zipfile -e "$PACKAGES/gamephys@v$version-$system.zip" unpacked
mkdir client
cp "$SOURCE/bindings/go/examples/pick/main.go" client
printf 'module client\n\ngo 1.18\n\nrequire gamephys v%s\nreplace gamephys => ../unpacked/%s\n' "$version" "$module" >client/go.mod
go_empty() { empty GOPROXY=off GOFLAGS=-mod=mod GOCACHE="$WORK/cache" PKG_CONFIG_PATH=/nowhere "$@"; }
(cd client && go_empty go run .)
(cd "unpacked/$module" && go_empty go test -count=1 . && go_empty go vet .)
chmod -R u+w home
