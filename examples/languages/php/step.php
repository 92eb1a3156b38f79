<?php
// A rope with a weight, and a cloth that falls over a ball.
require __DIR__ . '/gamephys.php';

$scene = made('gphys_scene', fn($out) => $gp->gphys_scene_create(null, $out));
$model = $gp->new('gphys_model_id');
$ground = value('gphys_plane', [[0, 1, 0], 0]);
$ball = value('gphys_sphere', [[0, 1, 0], 1]);
must($gp->gphys_scene_add($scene, $gp->GPHYS_SHAPE_PLANE, FFI::addr($ground), null, null, FFI::addr($model)));
must($gp->gphys_scene_add($scene, $gp->GPHYS_SHAPE_SPHERE, FFI::addr($ball), null, null, FFI::addr($model)));

$solver = made('gphys_solver', fn($out) => $gp->gphys_solver_create(null, $out));
$desc = $gp->new('gphys_body_desc');
must($gp->gphys_body_desc_init(FFI::addr($desc), FFI::sizeof($desc)));
$desc->damping = 2;

$line = value('gphys_vec3[41]', array_map(fn($i) => [5 + 0.05 * $i, 3, 0], range(0, 40)));
$weight = value('float[1]', [5]);
$body = $gp->new('gphys_body_id');
must($gp->gphys_solver_add_rope($solver, FFI::addr($desc), $line, 12, 41, 0, FFI::addr($body)));
$rope = $body->cdata;
must($gp->gphys_solver_set_pinned($solver, $rope, 0, 1, 1));
must($gp->gphys_solver_set_masses($solver, $rope, 40, 1, $weight, 4));

$desc->radius = 0.02;
$desc->cloth_flags = $gp->GPHYS_CLOTH_BEND;
[$corner, $along, $across] = array_map(fn($v) => value('gphys_vec3', $v), [[-1.5, 3, -1.5], [3, 0, 0], [0, 0, 3]]);
must($gp->gphys_solver_add_cloth($solver, FFI::addr($desc), FFI::addr($corner), FFI::addr($along), FFI::addr($across),
    31, 31, FFI::addr($body)));

$steps = $gp->new('uint32_t');
$positions = $gp->new('gphys_vec3[961]');
for ($frame = 0; $frame < 6 * 60; ++$frame) {
    must($gp->gphys_solver_advance($solver, $scene, 1 / 60, FFI::addr($steps), null));
    must($gp->gphys_solver_get_positions($solver, $body->cdata, 0, 961, $positions, 12)); // the same memory each frame
}

$height = INF;
foreach ($positions as $p) {
    $height = min($height, sqrt($p->x ** 2 + ($p->y - 1) ** 2 + $p->z ** 2) - 1);
}
$end = $gp->new('gphys_vec3');
must($gp->gphys_solver_get_positions($solver, $rope, 40, 1, FFI::addr($end), 12));
printf("weight %.3f m below the nail, cloth %.4f m above the ball\n", 3 - $end->y, $height);
expect($end->y < 1.02 && $height > 0.015 && $height < 0.03);
$gp->gphys_solver_destroy($solver);
$gp->gphys_scene_destroy($scene);
