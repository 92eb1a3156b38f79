// `npm start` as the README has it: it brings the module up to date, then serves the page.
import assert from 'node:assert';
import { spawn } from 'node:child_process';
import test from 'node:test';

test('npm start serves the page', async (t) => {
    const server = spawn('npm', ['start', '--', '--port', '0'], {
        cwd: new URL('..', import.meta.url), detached: true, stdio: ['ignore', 'pipe', 'inherit'], env: { ...process.env, NO_COLOR: '1' },
    });
    t.after(() => process.kill(-server.pid)); // npm and what it has started
    let said = '', address;
    for await (const text of server.stdout) {
        said += text;
        address = /Local:\s+(http:\S+)/.exec(said)?.[1];
        if (address) break;
    }
    assert(address, said);
    const page = await (await fetch(address)).text();
    assert.match(page, /<td id="visible">/);
    for (const [, script] of page.matchAll(/<script[^>]* src="([^"]+)"/g)) {
        const answer = await fetch(new URL(script, address));
        assert.strictEqual(answer.status, 200, script);
        assert.match(answer.headers.get('content-type'), /javascript/, script);
    }
});
