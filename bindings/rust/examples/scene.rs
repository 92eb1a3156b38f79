//! A scene and questions to it, one by one and in a batch.
use gamephys::*;

fn main() -> Result<()> {
    let mut scene = Scene::new(None)?;
    let ground = scene.add(&Plane::new([0.0, 1.0, 0.0], 0.0), None, None)?;

    // A row of 100 pyramids that share one mesh, which they keep alive.
    let places: Vec<_> = (0..100).map(|i| Transform::new([5.0 * i as f32, 0.0, 10.0], Quat::default(), 1.0)).collect();
    let mut pyramids = vec![0; places.len()];
    {
        let corners = [[-1.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 0.0, 1.0], [-1.0, 0.0, 1.0], [0.0, 2.0, 0.0]];
        let mesh = Mesh::new(&corners, &[0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4], None)?;
        assert_eq!(mesh.get_report()?.open_edge_count, 0);
        scene.add_batch(Shapes::one(&mesh), &places, None, &mut pyramids)?;
    }
    let ahead = Ray::new([25.0, 1.0, 0.0], [0.0, 0.0, 1.0], f32::INFINITY);
    let hit = scene.raycast(&ahead, ALL_LAYERS)?.expect("a pyramid");
    println!("ray: a pyramid, triangle {}, {:.3} m away", hit.triangle, hit.t);
    assert!(hit.model == pyramids[5] && (hit.t - 9.5).abs() < 1e-6);
    assert!(scene.raycast(&Ray { direction: [0.0, 1.0, 0.0].into(), ..ahead }, ALL_LAYERS)?.is_none());
    assert_eq!(scene.overlap(&Aabb::new([-1.0, 0.5, 8.0], [21.0, 1.0, 12.0]), ALL_LAYERS)?.len(), 5);
    assert_eq!(scene.nearest([0.0, 10.0, -50.0], f32::INFINITY, ALL_LAYERS)?.expect("the ground").model, ground);

    // One call for 1000 rays that look down.
    let rays: Vec<_> = (0..1000).map(|i| Ray::new([0.5 * i as f32, 5.0, 10.0], [0.0, -1.0, 0.0], 10.0)).collect();
    let mut hits = vec![Hit::default(); rays.len()];
    scene.raycast_batch(&rays, ALL_LAYERS, &mut hits)?;
    let above = hits.iter().filter(|hit| hit.t < 5.0).count();
    println!("{above} of 1000 rays end on a pyramid");
    assert_eq!(above, 299);
    Ok(())
}
