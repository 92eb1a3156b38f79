#include <gamephys_c.h>
#include <stdio.h>

int main(void) {
    gphys_scene* scene;
    gphys_sphere ball = {{0, 0, 5}, 1};
    gphys_ray ray = {{0, 0, 0}, {0, 0, 1}, 100};
    gphys_model_id model;
    gphys_hit hit;
    if (gphys_scene_create(NULL, &scene) != GPHYS_OK) return 1;
    if (gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &model) != GPHYS_OK) return 1;
    if (gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit) != GPHYS_OK) return 1;
    printf("hit at %g m\n", hit.t);
    gphys_scene_destroy(scene);
    return hit.model == model && hit.t == 4 ? 0 : 1;
}
