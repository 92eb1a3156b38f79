// The mouse: what is under it, orbit, pan and zoom, a rectangle to select, bodies to pull.
export class Controls {
    #mode;
    #from;
    constructor(canvas, marquee, app) {
        const at = (event) => {
            const box = canvas.getBoundingClientRect();
            return [event.clientX - box.left + 0.5, event.clientY - box.top + 0.5]; // the middle of the mouse's pixel
        };
        const outline = ([x, y]) => {
            const [fx, fy] = this.#from;
            Object.assign(marquee.style, {
                display: 'block', left: `${Math.min(x, fx)}px`, top: `${Math.min(y, fy)}px`, width: `${Math.abs(x - fx)}px`, height: `${Math.abs(y - fy)}px`,
            });
        };

        canvas.addEventListener('pointerdown', (event) => {
            canvas.setPointerCapture(event.pointerId);
            this.#from = at(event);
            if (event.button === 2) this.#mode = 'pan';
            else if (event.shiftKey) this.#mode = 'select';
            else this.#mode = app.world.grab(...this.#from) ? 'pull' : 'orbit';
        });
        canvas.addEventListener('pointermove', (event) => {
            const to = at(event);
            app.mouse = to;
            const { camera } = app.world;
            const [right, down] = [to[0] - this.#from?.[0], to[1] - this.#from?.[1]];
            if (this.#mode === 'orbit') camera.orbitRotate(right, down);
            if (this.#mode === 'pan') camera.orbitPan(-right * app.metresPerPixel, down * app.metresPerPixel);
            if (this.#mode === 'orbit' || this.#mode === 'pan') this.#from = to;
            if (this.#mode === 'select') outline(to);
            if (this.#mode === 'pull') app.world.drag(...to);
        });
        canvas.addEventListener('pointerup', (event) => {
            if (this.#mode === 'pull') app.world.release();
            if (this.#mode === 'select') {
                marquee.style.display = 'none';
                const to = at(event);
                if (to[0] !== this.#from[0] && to[1] !== this.#from[1]) app.select(...this.#from, ...to);
            }
            this.#mode = undefined;
        });
        canvas.addEventListener('pointerleave', () => (app.mouse = undefined));
        canvas.addEventListener('contextmenu', (event) => event.preventDefault());
        canvas.addEventListener('wheel', (event) => {
            event.preventDefault();
            // A tenth of the distance for each notch of 100.
            app.world.camera.orbitZoom((-event.deltaY / 1000) * app.world.camera.getOrbit().distance);
        }, { passive: false });
    }
}
