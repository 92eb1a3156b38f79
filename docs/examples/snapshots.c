/* Whole states as words: to save, to undo, to compare. */
#include "check.h"

/* A saved game: the snapshot is complete with its meshes, and another scene is restored
 * from it. Ids stay. */
static void save(const gphys_scene* scene, gphys_model_id crate) {
    uint32_t count;
    gphys_scene_get_snapshot(scene, 1, NULL, 0, &count);
    uint32_t* words = malloc(count * sizeof *words);
    /* The words may go to a file: fwrite(words, sizeof *words, count, file). */
    MUST(gphys_scene_get_snapshot(scene, 1, words, count, &count));

    gphys_scene* loaded = NULL;
    MUST(gphys_scene_create(NULL, &loaded));
    MUST(gphys_scene_restore(loaded, NULL, words, count));
    MUST(gphys_scene_has(loaded, crate));
    gphys_scene_destroy(loaded);
    free(words);
}

/* Undo in an editor: a snapshot before the change, without the meshes, and back to it.
 */
static void undo(gphys_scene* scene, gphys_model_id crate) {
    uint32_t words[256], count;
    MUST(gphys_scene_get_snapshot(scene, 0, words, 256, &count));
    MUST(gphys_scene_remove(scene, crate));
    MUST(gphys_scene_restore(scene, NULL, words, count));
    MUST(gphys_scene_has(scene, crate));
}

/* Two players' machines compare their scenes by 64 bits. Another tag is another state.
 */
static void compare(gphys_scene* scene, gphys_model_id crate) {
    uint32_t before[2], after[2];
    MUST(gphys_scene_get_hash(scene, before));
    MUST(gphys_scene_set_tag(scene, crate, 7));
    MUST(gphys_scene_get_hash(scene, after));
    EXPECT(before[0] != after[0] || before[1] != after[1]);
}

/* Rollback: the state before a step, the step, and the same step again with the same
 * bits. */
static void roll_back(gphys_solver* solver) {
    uint32_t count, first[2], second[2];
    gphys_solver_get_snapshot(solver, NULL, 0, &count);
    uint32_t* words = malloc(count * sizeof *words);
    MUST(gphys_solver_get_snapshot(solver, words, count, &count));
    MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    MUST(gphys_solver_get_hash(solver, first));
    MUST(gphys_solver_restore(solver, words, count));
    MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    MUST(gphys_solver_get_hash(solver, second));
    EXPECT(first[0] == second[0] && first[1] == second[1]);
    free(words);
}

int main(void) {
    const gphys_aabb box = {{0, 0, 0}, {1, 1, 1}};
    const gphys_vec3 points[3] = {{0, 5, 0}, {1, 5, 0}, {2, 5, 0}};
    gphys_scene* scene = NULL;
    gphys_solver* solver = NULL;
    gphys_model_id crate;
    gphys_body_id rope;
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &box, NULL, NULL, &crate));
    MUST(gphys_solver_create(NULL, &solver));
    MUST(gphys_solver_add_rope(solver, NULL, points, sizeof points[0], 3, 0, &rope));
    save(scene, crate);
    undo(scene, crate);
    compare(scene, crate);
    roll_back(solver);
    gphys_scene_destroy(scene);
    gphys_solver_destroy(solver);
    return 0;
}
