<?php
// A scene and questions to it, one by one and in a batch.
require __DIR__ . '/gamephys.php';

const LAYER_WORLD = 1, LAYER_ROBOT = 2;
const IDENTITY = [0, 0, 0, 1];

$scene = made('gphys_scene', fn($out) => $gp->gphys_scene_create(null, $out));
$id = $gp->new('gphys_model_id');
$add = function (int $type, FFI\CData $shape, ?FFI\CData $place = null, ?FFI\CData $desc = null) use ($gp, $scene, $id) {
    $optional = fn($value) => $value ? FFI::addr($value) : null;
    must($gp->gphys_scene_add($scene, $type, FFI::addr($shape), $optional($place), $optional($desc), FFI::addr($id)));
    return $id->cdata;
};
$ground = $add($gp->GPHYS_SHAPE_PLANE, value('gphys_plane', [[0, 1, 0], 0]));

// A row of 100 pyramids, five metres apart, that share one mesh, which they keep alive.
$vertices = value('float[15]', [-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0]);
$indices = value('uint32_t[18]', [0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4]);
$mesh = made('gphys_mesh', fn($out) => $gp->gphys_mesh_create(null, $vertices, 12, 5, $indices, 18, $out));
$places = value('gphys_transform[100]', array_map(fn($i) => [[5 * $i, 0, 10], IDENTITY, 1], range(0, 99)));
$pyramids = $gp->new('gphys_model_id[100]');
must($gp->gphys_scene_add_batch($scene, $gp->GPHYS_SHAPE_MESH, $mesh, 0, $places, 32, 100, null, $pyramids));
$gp->gphys_mesh_destroy($mesh);

// A robot's arm, and a hand two metres above it that follows.
$desc = $gp->new('gphys_model_desc');
must($gp->gphys_model_desc_init(FFI::addr($desc), FFI::sizeof($desc)));
$desc->layers = LAYER_ROBOT;
$bone = value('gphys_capsule', [[0, 0, 0], [0, 1, 0], 0.2]);
$arm = $add($gp->GPHYS_SHAPE_CAPSULE, $bone, value('gphys_transform', [[0, 1, -5], IDENTITY, 1]), $desc);
$desc->parent = $arm;
$ball = value('gphys_sphere', [[0, 0, 0], 0.5]);
$hand = $add($gp->GPHYS_SHAPE_SPHERE, $ball, value('gphys_transform', [[0, 2, 0], IDENTITY, 1]), $desc);

$hit = $gp->new('gphys_hit');
$forward = value('gphys_ray', [[25, 1, 0], [0, 0, 1], INF]);
must($gp->gphys_scene_raycast($scene, FFI::addr($forward), ALL_LAYERS, FFI::addr($hit)));
echo "ray: a pyramid, triangle $hit->triangle, $hit->t m away\n";
expect($hit->model === $pyramids[5] && abs($hit->t - 9.5) < 1e-6);

$sight = value('gphys_segment', [[0, 3, -10], [0, 3, 0]]);
$blocked = fn(int $layers) => must($gp->gphys_scene_segment_test($scene, FFI::addr($sight), $layers, FFI::addr($hit))) === 0;
expect($blocked(ALL_LAYERS) && $hit->model === $hand && !$blocked(LAYER_WORLD));
$moved = value('gphys_transform', [[0, 1, -50], IDENTITY, 1]);
must($gp->gphys_scene_set_transform($scene, $arm, FFI::addr($moved)));
expect(!$blocked(ALL_LAYERS));

$box = value('gphys_aabb', [[-1, 0.5, 8], [21, 1, 12]]);
$found = $gp->new('gphys_model_id[3]'); // has room for three
$total = $gp->new('uint32_t');
$overlap = $gp->gphys_scene_overlap($scene, $gp->GPHYS_SHAPE_AABB, FFI::addr($box), LAYER_WORLD, $found, 3, FFI::addr($total));
echo "box: $total->cdata models, the first three are $found[0] $found[1] $found[2]\n";
expect(must($overlap) === $gp->GPHYS_INCOMPLETE && $total->cdata === 5 && $found[0] < $found[1] && $found[1] < $found[2]);

try {
    $add($gp->GPHYS_SHAPE_SPHERE, value('gphys_sphere', [[0, 0, 0], NAN]));
    expect(false);
} catch (RuntimeException $e) {
    echo 'an error: ', $e->getMessage(), "\n";
    expect($e->getCode() === $gp->GPHYS_ERROR_INVALID_ARGUMENT);
}

// One call for 1000 rays that look down.
$rays = value('gphys_ray[1000]', array_map(fn($i) => [[0.5 * $i, 5, 10], [0, -1, 0], 10], range(0, 999)));
$hits = $gp->new('gphys_hit[1000]');
must($gp->gphys_scene_raycast_batch($scene, $rays, FFI::sizeof($rays[0]), 1000, LAYER_WORLD, $hits, FFI::sizeof($hits[0])));
$above = 0;
foreach ($hits as $one) {
    $above += $one->t < 5;
}
echo "batch: $above of 1000 rays end on a pyramid\n";
expect($above === 299);
$gp->gphys_scene_destroy($scene);
