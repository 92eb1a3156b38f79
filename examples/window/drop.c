/* Preloaded by test.sh: drops the file $DROP on the window before its third frame. */
#define _GNU_SOURCE
#include <SDL.h>

#include <dlfcn.h>
#include <stdlib.h>

void SDL_GL_SwapWindow(SDL_Window* window) {
    static int frame = 0;
    if (++frame == 2) {
        SDL_Event event = {.drop = {.type = SDL_DROPFILE, .file = SDL_strdup(getenv("DROP"))}};
        SDL_PushEvent(&event);
    }
    void (*swap)(SDL_Window*);
    *(void**)&swap = dlsym(RTLD_NEXT, "SDL_GL_SwapWindow");
    swap(window);
}
