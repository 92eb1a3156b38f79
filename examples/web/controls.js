// The mouse and fingers: what is under them, orbit, pan and zoom, a rectangle to select, bodies to pull.
export class Controls {
    #app;
    #marquee;
    #pointers = new Map(); // where each is that is down, by its number
    #mode;
    #start; // of a pinch: the distance between two fingers, and to the target

    constructor(canvas, marquee, app) {
        this.#app = app;
        this.#marquee = marquee;
        const at = (event) => {
            const box = canvas.getBoundingClientRect();
            return [event.clientX - box.left + 0.5, event.clientY - box.top + 0.5]; // the middle of the mouse's pixel
        };
        let from; // where the pointer went down, or was before
        canvas.addEventListener('pointerdown', (event) => {
            this.#stop();
            canvas.setPointerCapture(event.pointerId);
            this.#pointers.set(event.pointerId, at(event));
            from = at(event);
            if (this.#pointers.size > 1) this.#startPinch();
            else if (event.button === 2) this.#mode = 'pan';
            else if (event.shiftKey) this.#mode = 'select';
            else this.#mode = app.world.grab(...from) ? 'pull' : 'orbit';
        });
        canvas.addEventListener('pointermove', (event) => {
            const to = at(event);
            app.mouse = to;
            if (this.#mode === 'pinch') return this.#pinch(event.pointerId, to);
            if (this.#mode === 'orbit') app.world.camera.orbitRotate(to[0] - from[0], to[1] - from[1]);
            if (this.#mode === 'pan') this.#pan(to[0] - from[0], to[1] - from[1]);
            if (this.#mode === 'orbit' || this.#mode === 'pan') from = to;
            if (this.#mode === 'select') this.#outline(from, to);
            if (this.#mode === 'pull') app.world.drag(...to);
        });
        canvas.addEventListener('pointerup', (event) => {
            const to = at(event);
            if (this.#mode === 'select' && to[0] !== from[0] && to[1] !== from[1]) app.select(...from, ...to);
        });
        // Without pointerup if the browser or the system takes the pointer.
        for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
            canvas.addEventListener(end, ({ pointerId }) => this.#pointers.delete(pointerId) && this.#stop());
        }
        canvas.addEventListener('pointerleave', () => (app.mouse = undefined));
        canvas.addEventListener('contextmenu', (event) => event.preventDefault());
        canvas.addEventListener('wheel', (event) => {
            event.preventDefault();
            // A tenth of the distance for each notch of 100.
            app.world.camera.orbitZoom((-event.deltaY / 1000) * app.world.camera.getOrbit().distance);
        }, { passive: false });
    }

    #stop() {
        if (this.#mode === 'pull') this.#app.world.release();
        if (this.#mode === 'select') this.#marquee.style.display = 'none';
        this.#mode = undefined;
    }

    #pan(right, down) {
        const { metresPerPixel, world } = this.#app;
        world.camera.orbitPan(-right * metresPerPixel, down * metresPerPixel);
    }

    #outline([fx, fy], [x, y]) {
        Object.assign(this.#marquee.style, {
            display: 'block', left: `${Math.min(x, fx)}px`, top: `${Math.min(y, fy)}px`, width: `${Math.abs(x - fx)}px`, height: `${Math.abs(y - fy)}px`,
        });
    }

    /** Of the first two fingers: the middle, and the distance between them. */
    #fingers() {
        const [[ax, ay], [bx, by]] = this.#pointers.values();
        return { x: (ax + bx) / 2, y: (ay + by) / 2, span: Math.max(1, Math.hypot(ax - bx, ay - by)) };
    }

    #startPinch() {
        this.#mode = 'pinch';
        this.#start = { span: this.#fingers().span, distance: this.#app.world.camera.getOrbit().distance };
    }

    /** What is between two fingers grows as their distance, and moves with their middle. */
    #pinch(pointer, to) {
        if (!this.#pointers.has(pointer)) return;
        const before = this.#fingers();
        this.#pointers.set(pointer, to);
        const after = this.#fingers(), { span, distance } = this.#start;
        this.#pan(after.x - before.x, after.y - before.y);
        this.#app.world.camera.orbitZoom(distance * span * (1 / before.span - 1 / after.span));
    }
}
