/* Load the library named by the argument, use it, let a call fail, unload it, and look whether it
 * is gone. A thread-local object with a destructor would keep it. */
#include <dlfcn.h>
#include <gamephys_c.h>
#include <stdio.h>
#include <string.h>

static int loaded(void) {
    char line[4096];
    int found = 0;
    FILE* maps = fopen("/proc/self/maps", "r");
    while (maps && fgets(line, sizeof line, maps)) found |= strstr(line, "libgamephys") != NULL;
    if (maps) fclose(maps);
    return found;
}

int main(int argc, char** argv) {
    void* library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    if (!library) return 1;
    gphys_status (*create)(const gphys_scene_desc*, gphys_scene**);
    void (*destroy)(gphys_scene*);
    const char* (*last_error)(void);
    /* POSIX's own way around the conversion of an object pointer to a function pointer. */
    *(void**)&create = dlsym(library, "gphys_scene_create");
    *(void**)&destroy = dlsym(library, "gphys_scene_destroy");
    *(void**)&last_error = dlsym(library, "gphys_last_error");
    gphys_scene* scene = NULL;
    if (create(NULL, &scene) != GPHYS_OK) return 2;
    destroy(scene);
    if (create(NULL, NULL) != GPHYS_ERROR_INVALID_ARGUMENT || last_error()[0] == '\0') return 3;
    if (!loaded()) return 4;
    dlclose(library);
    return loaded() ? 5 : 0;
}
