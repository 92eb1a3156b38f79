#!/usr/bin/env bash
# The web page of examples/web, built: a folder of static files for any server, which visitors need not build. It is
# unpacked into an empty folder and opened in a headless browser.
source "$(dirname "$0")/common.sh"
export npm_config_update_notifier=false npm_config_fund=false npm_config_audit=false

(cd "$SOURCE/bindings/javascript" && npm pack --silent --pack-destination "$WORK") >/dev/null
mkdir page
(cd "$SOURCE/examples/web" && cp ./*.js index.html package.json "$WORK/page")
cd page
npm pkg set dependencies.gamephys="file:$WORK/gamephys-$version.tgz"
npm install --silent
node_modules/.bin/vite build --logLevel warn
page=$PACKAGES/gamephys-page-$version.zip
rm -f "$page"
(cd dist && python3 -m zipfile -c "$page" ./*)

mkdir "$WORK/site"
python3 -m zipfile -e "$page" "$WORK/site/some/folder"
python3 -m http.server --bind 127.0.0.1 --directory "$WORK/site" 0 >"$WORK/server.log" 2>&1 &
server=$!
trap 'kill $server' EXIT
until port=$(sed -n 's/.*port \([0-9]*\).*/\1/p' "$WORK/server.log") && [ -n "$port" ]; do sleep 0.1; done
chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist \
    --user-data-dir="$WORK/profile" --virtual-time-budget=20000 --dump-dom "http://127.0.0.1:$port/some/folder/" \
    >"$WORK/dom.html" 2>"$WORK/chromium.log"
grep -q '<td id="visible">[0-9]* of 301</td>' "$WORK/dom.html" || fail "the page: $(cat "$WORK/dom.html" "$WORK/chromium.log")"
echo "the page draws, and culls 301 objects"
