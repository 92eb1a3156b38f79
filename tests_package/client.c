/* The smallest use of the library: exit status 0 if a ray meets a ball where it should. */
#include <gamephys_c.h>
#include <stdio.h>

int main(void) {
    const gphys_sphere ball = {{0, 0, 5}, 1};
    const gphys_ray ray = {{0, 0, 0}, {0, 0, 1}, 100};
    gphys_scene* scene = NULL;
    gphys_model_id model = 0;
    gphys_hit hit = {0};
    gphys_scene_create(NULL, &scene);
    gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &model);
    gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit);
    gphys_scene_destroy(scene);
    printf("model %u at %g m\n", (unsigned)hit.model, hit.t);
    return hit.model == model && hit.t == 4 ? 0 : 1;
}
