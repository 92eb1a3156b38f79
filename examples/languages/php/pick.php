<?php
// What a camera sees: culling, a picture of picks, projection, marquee, orbit.
require __DIR__ . '/gamephys.php';

const WIDTH = 64, HEIGHT = 16;

$scene = made('gphys_scene', fn($out) => $gp->gphys_scene_create(null, $out));
$shapes = value('gphys_sphere[4]', [[[-4, 0, 9], 1.5], [[0, 0, 9], 1.5], [[4, 0, 9], 1.5], [[0, 0, -50], 2]]);
$balls = $gp->new('gphys_model_id[4]');
must($gp->gphys_scene_add_batch($scene, $gp->GPHYS_SHAPE_SPHERE, $shapes, 16, null, 0, 4, null, $balls));

$desc = $gp->new('gphys_camera_desc');
must($gp->gphys_camera_desc_init(FFI::addr($desc), FFI::sizeof($desc)));
$desc->viewport_width = 10 * WIDTH;
$desc->viewport_height = 20 * HEIGHT;
$camera = made('gphys_camera', fn($out) => $gp->gphys_camera_create(FFI::addr($desc), $out));
must($gp->gphys_camera_set_perspective($camera, 0.7, 0.1, 100));
$orbit = $gp->new('gphys_orbit');
must($gp->gphys_orbit_init(FFI::addr($orbit)));
$orbit->target->z = 9;
$orbit->distance = 8;
$orbit->radians_per_unit = 0.01;
must($gp->gphys_camera_set_orbit($camera, FFI::addr($orbit)));
$seen = $gp->new('gphys_model_id[4]');
$total = $gp->new('uint32_t');
must($gp->gphys_camera_cull($camera, $scene, ALL_LAYERS, $seen, 4, FFI::addr($total)));
expect($total->cdata === 3);

// A ray for each character cell, all in one batch.
$cells = WIDTH * HEIGHT;
$pixels = $gp->new("float[$cells][2]");
for ($i = 0; $i < $cells; ++$i) {
    fill($pixels[$i], [10 * ($i % WIDTH + 0.5), 20 * (intdiv($i, WIDTH) + 0.5)]);
}
$hits = $gp->new("gphys_hit[$cells]");
must($gp->gphys_camera_pick_batch($camera, $scene, $pixels[0], 8, $cells, ALL_LAYERS, $hits, FFI::sizeof($hits[0])));
$picture = '';
foreach ($hits as $hit) {
    $light = max(0, min(1, -0.5 * $hit->normal->x + 0.6 * $hit->normal->y - 0.6 * $hit->normal->z));
    $picture .= $hit->model ? '@%#*+=-:.'[8 - (int) (8 * $light)] : ' ';
}
foreach (str_split($picture, WIDTH) as $row) {
    echo rtrim($row), "\n";
}

$pixel = $gp->new('gphys_vec3');
$hit = $gp->new('gphys_hit');
must($gp->gphys_camera_project($camera, FFI::addr($shapes[0]->center), FFI::addr($pixel)));
must($gp->gphys_camera_pick($camera, $scene, $pixel->x, $pixel->y, ALL_LAYERS, FFI::addr($hit)));
expect($hit->model === $balls[0]);
must($gp->gphys_camera_pick_rectangle($camera, $scene, 340, 0, 640, 320, ALL_LAYERS, $seen, 4, FFI::addr($total)));
expect($total->cdata === 2 && $seen[0] === $balls[1] && $seen[1] === $balls[2]);

must($gp->gphys_camera_orbit_rotate($camera, 157.0796, 0)); // pixels of mouse movement: a quarter turn
must($gp->gphys_camera_orbit_update($camera));
$ray = $gp->new('gphys_ray');
$behind = $gp->new('gphys_hit[4]');
must($gp->gphys_camera_pick_ray($camera, 320, 160, FFI::addr($ray)));
must($gp->gphys_scene_raycast_all($scene, FFI::addr($ray), ALL_LAYERS, $behind, 4, FFI::addr($total)));
expect($total->cdata === 3 && $behind[1]->model === $balls[1]);
echo "after a quarter turn $total->cdata balls stand behind one another\n";
$gp->gphys_camera_destroy($camera);
$gp->gphys_scene_destroy($scene);
