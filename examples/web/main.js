// The page: each frame moves what bends, asks what is in view and under the mouse, and draws.
import { Controls } from './controls.js';
import { bunnyGeometry, objGeometry } from './meshes.js';
import { PRESETS } from './presets.js';
import { View } from './view.js';
import { World } from './world.js';

const FIELD_OF_VIEW = 0.8; // from top to bottom
const element = (id) => document.getElementById(id);
const canvas = element('view');
const view = new View(canvas);

/** Calls, and shows the longest time of the last second in a cell of the table. */
const longest = new Map();
function timed(cell, call) {
    const start = performance.now();
    const result = call();
    const time = performance.now() - start;
    const shown = longest.get(cell);
    if (!shown || time > shown.time || start - shown.start > 1000) {
        longest.set(cell, { time, start });
        element(cell).textContent = `${time.toFixed(2)} ms`;
    }
    return result;
}

const app = {
    geometry: bunnyGeometry(),
    selected: new Set(),
    hovered: undefined, // the number of the object under the mouse
    mouse: undefined, // its pixel
    frames: 0,
    seconds: 0, // simulated
    paused: false,
    speed: 1,

    build() {
        this.world?.close();
        const positions = this.geometry.getAttribute('position').array, { array } = this.geometry.index;
        element('counted').hidden = element('preset').value !== 'statues';
        const build = PRESETS[element('preset').value], count = Number(element('count').value);
        this.world = new World(positions, Uint32Array.from(array), (world) => build(world, count));
        this.world.camera.setPerspective(FIELD_OF_VIEW, 0.1, 2000);
        this.resize();
        this.world.orbit();
        this.choose([]);
        this.seconds = 0;
        view.show(this.world, this.geometry);
        view.showOctree(element('octree').checked);
    },

    resize() {
        const { clientWidth, clientHeight } = canvas;
        view.renderer.setPixelRatio(Math.min(devicePixelRatio, 2)); // more is not seen, but drawn
        view.renderer.setSize(clientWidth, clientHeight, false);
        this.world.camera.setViewport(clientWidth, clientHeight);
    },

    /** At the target's distance. */
    get metresPerPixel() {
        return (2 * Math.tan(FIELD_OF_VIEW / 2) * this.world.camera.getOrbit().distance) / canvas.clientHeight;
    },

    select(x0, y0, x1, y1) {
        this.choose(timed('selection', () => this.world.pickRectangle(x0, y0, x1, y1)));
    },

    choose(numbers) {
        this.selected = new Set(numbers);
        element('selected').textContent = this.selected.size;
    },

    frame(seconds) {
        const { world } = this;
        this.seconds += seconds;
        if (seconds > 0) timed('step', () => world.step(seconds));
        world.camera.orbitUpdate();
        const visible = timed('cull', () => world.visible());
        const under = this.mouse && timed('pick', () => world.pick(...this.mouse));
        this.hovered = under?.number;
        this.visible = visible;
        element('visible').textContent = `${visible.length} of ${world.ids.length}`;
        element('hovered').textContent = !under ? 'nothing' : under.number === undefined ? 'ground' : `${under.number}, ${under.hit.t.toFixed(2)} m`;
        const { contact_count, strain_max } = world.solver.getStats(0);
        element('contacts').textContent = contact_count;
        element('strain').textContent = `${(100 * strain_max).toFixed(2)} %`;
        view.draw(visible, this.hovered, this.selected);
    },
};

new Controls(canvas, element('marquee'), app);
for (const name of Object.keys(PRESETS)) element('preset').add(new Option(name));
for (const choice of ['preset', 'count']) element(choice).addEventListener('change', () => app.build());
element('octree').addEventListener('change', (event) => view.showOctree(event.target.checked));
element('mesh').addEventListener('change', async ({ target }) => {
    if (!target.files.length) return;
    app.geometry = objGeometry(await target.files[0].text());
    app.build();
});
addEventListener('resize', () => app.resize());
addEventListener('keydown', ({ key, target }) => {
    if (target.tagName === 'SELECT') return;
    if (key === ' ') app.paused = !app.paused;
    if (key === '.') app.paused = app.once = true; // a single step
    if (key === '[') app.speed = Math.max(app.speed / 2, 1 / 16);
    if (key === ']') app.speed = Math.min(app.speed * 2, 4);
});

element('panel').open = innerWidth > 600; // on a telephone it would cover the scene
app.build();
let before = performance.now(), frames = 0, since = before;
function loop(time) {
    const passed = Math.min(Math.max(0, time - before) / 1000, 1 / 30); // where drawing is slow, slow motion
    app.frame(app.once ? 1 / 60 : app.paused ? 0 : app.speed * passed);
    app.once = false;
    before = time;
    frames += 1;
    app.frames += 1;
    if (time - since > 500) {
        element('frame').textContent = `${((time - since) / frames).toFixed(1)} ms`;
        frames = 0;
        since = time;
    }
    requestAnimationFrame(loop);
}
requestAnimationFrame(loop);

globalThis.app = app; // for the console, and the tests
globalThis.view = view;
