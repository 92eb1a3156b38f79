#!/usr/bin/env bash
# The npm tarball with the WebAssembly inside, SIMD on. It is installed into an empty project and used by Node, by
# pages that bundlers made, and by a page without one, all in a headless browser.
source "$(dirname "$0")/common.sh"
export npm_config_update_notifier=false npm_config_fund=false npm_config_audit=false

rm -f "$PACKAGES"/gamephys-*.tgz
cp -r "$SOURCE/bindings/javascript/examples" .
(cd "$SOURCE/bindings/javascript" && npm pack --silent --pack-destination "$PACKAGES") >/dev/null
package=$PACKAGES/gamephys-$version.tgz

mkdir client
cd client
printf '{"name": "client", "type": "module", "private": true}\n' >package.json
npm install --silent --omit=optional "$package"
npm install --silent --save-dev vite typescript webpack webpack-cli esbuild
cp "$SOURCE"/bindings/javascript/examples/{scene,step,pick}.js .
for example in scene step pick; do
    empty node $example.js                      # no native library: WebAssembly
    empty node --conditions=browser $example.js # as bundlers resolve it
done
# A library that was asked for has to be there.
! empty GAMEPHYS_LIBRARY=/nowhere/libgamephys.so node pick.js 2>/dev/null || fail "a missing GAMEPHYS_LIBRARY was not noticed"
# Instructions of SIMD: 0xfd begins each. v128.load is 0xfd 0x00, and there are thousands.
node -e '
    const code = require("node:fs").readFileSync("node_modules/gamephys/gamephys.wasm");
    let loads = 0;
    for (let i = 0; i + 1 < code.length; ++i) if (code[i] === 0xfd && code[i + 1] === 0) ++loads;
    console.log(`gamephys.wasm: ${code.length} bytes, ${require("node:zlib").gzipSync(code).length} compressed, ${loads} loads of SIMD`);
    // The sizes that its README states, to a tenth.
    const [, size, packed] = /\(([\d.]+) MB, (\d+) KB with gzip\)/.exec(require("node:fs").readFileSync("node_modules/gamephys/README.md", "utf8"));
    const near = (stated, bytes) => Math.abs(stated - bytes) < 0.1 * bytes;
    if (!near(1e6 * size, code.length) || !near(1e3 * packed, require("node:zlib").gzipSync(code).length)) throw new Error("the README states other sizes");
    process.exit(loads > 1000 && WebAssembly.validate(code) ? 0 : 1);'

cat >types.ts <<'END'
import * as gp from 'gamephys';
const scene = new gp.Scene();
scene.add(gp.sphere([0, 0, 5], 1));
const hit = scene.raycast({ origin: [0, 0, 0], direction: [0, 0, 1], t_max: 100 });
export const t: number = hit!.t;
// @ts-expect-error: a radius is a number
gp.sphere([0, 0, 5], 'one');
END
node_modules/.bin/tsc --noEmit --strict --target es2022 --module nodenext types.ts

# Pages of several bundlers, and of none. The worker and what uses it are those of the guide. What they print they ask
# the server for, whose log has it then: a browser that prints its page does not wait for workers.
block() { awk -v first="// $1" '/^```/ { inside = 0 } $0 == first { inside = 1 } inside' "$SOURCE/docs/guide/web.md"; }
block worker.js >worker.js
block page.js | sed "s|console\.log(|fetch('/said: ' + |" >main.js
[ -s worker.js ] && [ -s main.js ] || fail "the guide has no program for workers"
cat >init.js <<'END'
import init from 'gamephys/init';
import file from 'gamephys/gamephys.wasm';
init(file).then((gp) => {
    const scene = new gp.Scene();
    scene.add(gp.sphere([0, 0, 5], 1));
    fetch(`/said: the ball is met at ${scene.raycast({ origin: [0, 0, 0], direction: [0, 0, 1] }).t}`);
});
END
mkdir webpack esbuild plain
printf '<!doctype html><script type="module" src="/main.js"></script>\n' >index.html
printf 'export default { build: { target: "esnext" }, base: "./", worker: { format: "es" } };\n' >vite.config.js
node_modules/.bin/vite build --logLevel warn
node_modules/.bin/webpack --mode production --entry ./main.js --output-path "$PWD/webpack" --no-performance >webpack.log || fail "$(cat webpack.log)"
node_modules/.bin/esbuild init.js --bundle --loader:.wasm=file --outfile=esbuild/main.js --log-level=warning
for script in main worker; do sed "s|'gamephys'|'../node_modules/gamephys/wasm.js'|" $script.js >plain/$script.js; done
printf '<!doctype html><script src="main.js"></script>\n' | tee webpack/index.html >esbuild/index.html
printf '<!doctype html><script type="module" src="main.js"></script>\n' >plain/index.html

python3 -m http.server --bind 127.0.0.1 0 >server.log 2>&1 &
server=$!
trap 'kill $server' EXIT
until port=$(sed -n 's/.*port \([0-9]*\).*/\1/p' server.log) && [ -n "$port" ]; do sleep 0.1; done
for page in {dist,webpack,esbuild,plain}/index.html; do
    said=$(wc -l <server.log)
    chromium --headless --no-sandbox --disable-gpu --user-data-dir="$WORK/profile" --remote-debugging-port=0 \
        "http://127.0.0.1:$port/$page" >chromium.log 2>&1 &
    browser=$!
    for ((i = 0; i < 300; ++i)); do
        if tail -n +$((said + 1)) server.log | grep -q '/said:%20the%20ball%20is%20met%20at%204 '; then break; fi
        sleep 0.1
    done
    kill $browser
    wait $browser || true
    [ "$i" -lt 300 ] || fail "$page: $(cat server.log chromium.log)"
    echo "$page: the ball is met"
done
