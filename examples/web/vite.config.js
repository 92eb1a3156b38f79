import { defineConfig } from 'vite';

export default defineConfig({
    server: { fs: { allow: ['../..'] } }, // the package is a link to bindings/javascript
    resolve: { conditions: ['browser'] },
    optimizeDeps: { exclude: ['gamephys'], include: ['bunny'] }, // its module is found beside its source
    base: './', // the built page works in any folder of a server
    build: { target: 'esnext' },
});
