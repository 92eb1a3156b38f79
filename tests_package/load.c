/* Load the library named by the first argument, use it, let calls fail, unload it. What is printed is
 * the library's: this program prints nothing. The other arguments are statuses and their names in
 * turn: exit status 3 if the library has another name for one, 6 if denormal numbers are flushed to zero once it has
 * been used. */
#include <dlfcn.h>
#include <float.h>
#include <gamephys_c.h>
#include <stdlib.h>
#include <string.h>

static int flushes(void) {
    volatile float least = FLT_MIN;
    least /= 2;
    return least == 0;
}

int main(int argc, char** argv) {
    void* library = argc > 1 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    if (!library) return 1;
    gphys_status (*create)(const gphys_scene_desc*, gphys_scene**);
    void (*destroy)(gphys_scene*);
    gphys_status (*validate)(gphys_shape_type, const void*);
    const char* (*status_name)(gphys_status);
    const char* (*last_error)(void);
    /* POSIX's own way around the conversion of an object pointer to a function pointer. */
    *(void**)&create = dlsym(library, "gphys_scene_create");
    *(void**)&destroy = dlsym(library, "gphys_scene_destroy");
    *(void**)&validate = dlsym(library, "gphys_shape_validate");
    *(void**)&status_name = dlsym(library, "gphys_status_name");
    *(void**)&last_error = dlsym(library, "gphys_last_error");
    if (!create || !destroy || !validate || !status_name || !last_error) return 2;
    for (int i = 2; i + 1 < argc; i += 2) {
        const char* name = status_name(atoi(argv[i]));
        if (!name || strcmp(name, argv[i + 1]) != 0) return 3;
    }
    gphys_scene* scene = NULL;
    create(NULL, &scene);
    destroy(scene);
    create(NULL, NULL);
    validate(-1, NULL);
    if (!last_error()) return 4;
    if (flushes()) return 6;
    return dlclose(library) == 0 ? 0 : 5;
}
