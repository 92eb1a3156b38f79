import static gamephys.Gamephys.*;
import static org.junit.Assert.*;

import com.sun.jna.Callback;
import com.sun.jna.CallbackReference;
import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import gamephys.*;
import java.nio.ByteBuffer;
import java.nio.ReadOnlyBufferException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;

/** Every function with an answer that is known, batches against single calls, errors, ownership. */
public class GamephysTest {
    static final Vec3 ZERO = new Vec3(0, 0, 0), UP = new Vec3(0, 1, 0);
    static final Quat STILL = new Quat(0, 0, 0, 1);
    static final Transform IDENTITY = Transform.IDENTITY;
    static final Sphere BALL = new Sphere(v(0, 0, 5), 1);
    static final Ray AHEAD = new Ray(ZERO, v(0, 0, 1), 100);

    static Vec3 v(double x, double y, double z) {
        return new Vec3((float) x, (float) y, (float) z);
    }

    static Batch<Vec3> points(Vec3... points) {
        return Batch.copyOf(Vec3.LAYOUT, List.of(points));
    }

    static Mesh pyramid(MeshDesc desc) {
        return new Mesh(
                Batch.floats(-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0),
                Batch.ints(0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4), desc);
    }

    static Mesh pyramid() {
        return pyramid(null);
    }

    static void assertVector(Vec3 expected, Vec3 actual, double tolerance) {
        assertEquals(expected.x(), actual.x(), tolerance);
        assertEquals(expected.y(), actual.y(), tolerance);
        assertEquals(expected.z(), actual.z(), tolerance);
    }

    static String assertFails(int status, ThrowingRunnable call) {
        GamephysException caught = assertThrows(GamephysException.class, call);
        assertEquals(status, caught.status());
        return caught.getMessage();
    }

    @Test
    public void aSceneThatIsClosedWhileOthersAskStaysUntilTheyAreDone() throws InterruptedException {
        Batch<Ray> rays = Batch.copyOf(Ray.LAYOUT, java.util.Collections.nCopies(20000, new Ray(v(-5, 3, 3), v(1, 0.1f, 0), 100)));
        for (int round = 0; round < 5; ++round) {
            Scene scene = new Scene();
            for (int i = 0; i < 2000; ++i) scene.add(new Sphere(v(i % 50, i / 50 % 50, i % 7), 1));
            List<String> ends = new java.util.concurrent.CopyOnWriteArrayList<>();
            Thread[] threads = new Thread[3];
            for (int i = 0; i < threads.length; ++i) {
                threads[i] = new Thread(() -> {
                    try {
                        for (;;) scene.raycastBatch(rays);
                    } catch (IllegalStateException closed) {
                        ends.add(closed.getMessage());
                    }
                });
                threads[i].start();
            }
            Thread.sleep(20);
            scene.close();
            for (Thread thread : threads) thread.join();
            assertEquals(java.util.Collections.nCopies(3, "Scene is closed"), ends);
        }
    }

    @Test
    public void shapes() {
        validate(BALL);
        assertEquals(new Aabb(v(-1, -1, 4), v(1, 1, 6)), bounds(BALL).orElseThrow());
        assertTrue(bounds(new Plane(UP, 0)).isEmpty());
        Shape moved = transform(new Aabb(ZERO, v(2, 2, 2)), new Transform(v(1, 0, 0), STILL, 1));
        assertEquals(v(2, 1, 1), ((Obb) moved).center());
        assertTrue(contains(BALL, v(0, 0, 4)));
        assertFalse(contains(BALL, v(0, 0, 3.5)));
        assertTrue(contains(BALL, v(0, 0, 3.5), 0.5f));
        assertEquals(List.of(1, 0), containsBatch(BALL, points(v(0, 0, 5), v(0, 0, 3))));
        assertEquals(4, closestPoint(BALL, ZERO).orElseThrow().distance(), 0);
        assertEquals(3, closestPointBatch(BALL, points(ZERO, v(0, 0, 9))).get(1).distance(), 0);
        assertEquals(new SegmentClosestPointsResult(v(1, 0, 0), v(1, 3, 0), 3),
                segmentClosestPoints(new Segment(ZERO, v(2, 0, 0)), new Segment(v(1, 3, -1), v(1, 3, 1))));
        assertTrue(overlaps(BALL, new Aabb(ZERO, v(1, 1, 4))));
        assertFalse(overlaps(BALL, new Aabb(ZERO, v(1, 1, 3))));
        assertEquals(List.of(1, 0), overlapsBatch(
                Shapes.of(List.of(new Sphere(ZERO, 1), new Sphere(v(0, 9, 0), 1))), Shapes.of(new Plane(UP, 0))));
        assertEquals(new ClassifyPlaneResult(SIDE_INSIDE, 4), classifyPlane(BALL, new Plane(v(0, 0, 1), 0)));
        Ray aside = new Ray(v(0, 3, 0), v(0, 0, 1), 9);
        assertEquals(4, raycast(BALL, AHEAD).orElseThrow().t(), 0);
        assertTrue(raycast(BALL, aside).isEmpty());
        Batch<Hit> hits = raycastBatch(BALL, Batch.copyOf(Ray.LAYOUT, List.of(AHEAD, aside)));
        assertEquals(4, hits.get(0).t(), 0);
        assertEquals(Float.POSITIVE_INFINITY, hits.get(1).t(), 0);
        assertEquals(0.5, segmentTest(BALL, new Segment(ZERO, v(0, 0, 8))).orElseThrow().t(), 0);
        assertEquals(0.3, sweepSphere(BALL, new Sphere(ZERO, 1), v(0, 0, 10)).orElseThrow().t(), 1e-6);
    }

    @Test
    public void aBatchMayBeEmpty() {
        Scene scene = new Scene();
        assertEquals(0, scene.addBatch(Shapes.of(List.<Shape>of())).size());
        assertEquals(0, scene.raycastBatch(Batch.copyOf(Ray.LAYOUT, List.<Ray>of())).size());
    }

    @Test
    public void frusta() {
        Camera camera = new Camera();
        Frustum frustum = camera.getFrustum();
        assertEquals(SIDE_INSIDE, classifyFrustum(BALL, frustum));
        List<Vec3> corners = frustumCorners(frustum).orElseThrow();
        assertEquals(8, corners.size());
        assertEquals(1000, corners.get(7).z(), 0.01);
        assertVector(camera.getCorners().orElseThrow().get(3), corners.get(3), 1e-5);
        Frustum again = frustumFromMatrix(camera.getViewProjectionMatrix(), DEPTH_ZERO_TO_ONE, false);
        assertEquals(SIDE_OUTSIDE, classifyFrustum(new Sphere(v(0, 0, -5), 1), again));
    }

    @Test
    public void meshes() {
        MeshReport report = meshCheck(Batch.floats(0, 0, 0, 1, 0, 0, 0, 1, 0), Batch.ints(0, 1, 7));
        assertEquals(1, report.triangleCount());
        assertEquals(1, report.outOfRangeCount());
        Mesh mesh = pyramid();
        assertEquals(0, mesh.getReport().openEdgeCount());
        assertEquals(v(0, 2, 0), mesh.getVertices().get(4));
        assertEquals(List.of(0, 3, 4), mesh.getIndices().subList(15, 18));
        assertEquals(mesh.getIndices(), new Mesh(mesh.getSnapshot()).getIndices());
        Ray down = new Ray(v(0.3, 5, 0.2), v(0, -1, 0), 10);
        Batch<Hit> hits = mesh.raycastAll(down);
        assertEquals(2, hits.size());
        assertEquals(5, hits.get(1).t(), 0);
        assertTrue(mesh.raycastAny(down));
        Batch<Ray> twice = Batch.allocate(Ray.LAYOUT, 2);
        twice.set(0, down);
        twice.set(1, down);
        assertEquals(List.of(1, 1), mesh.raycastAnyBatch(twice));
        assertTrue(mesh.raycastDistanceBatch(twice).get(1).t() < Float.POSITIVE_INFINITY);
        assertEquals(4, mesh.overlap(new Sphere(v(0, 2, 0), 0.1f)).size());
        assertEquals(6, mesh.getOctreeStats().itemCount());
        assertEquals(0, mesh.getOctreeBoxes().get(0).depth());
        assertEquals(hits.get(0).triangle(), raycast(mesh, down).orElseThrow().triangle());
    }

    @Test
    public void models() {
        Scene scene = new Scene(new SceneDesc().reserveModels(4).workerCount(2));
        int model = scene.add(BALL, null, new ModelDesc().tag(7));
        Batch<Integer> two = scene.addBatch(Shapes.of(List.of(new Sphere(v(9, 0, 0), 1), new Sphere(v(9, 5, 0), 2))),
                Batch.shared(Transform.LAYOUT, IDENTITY));
        assertTrue(scene.has(model) && scene.has(two.get(1)));
        assertFalse(scene.has(12345));
        assertEquals(3, scene.getModels().size());
        assertEquals(7, scene.getInfo(model).tag());
        assertEquals(new Sphere(v(9, 5, 0), 2), scene.getShape(two.get(1)));
        assertEquals(10, scene.getBounds(two.get(0)).orElseThrow().max().x(), 0);
        assertEquals(7, scene.getSceneBounds().orElseThrow().max().y(), 0);
        scene.setLayers(model, 4);
        scene.setTag(model, 8);
        assertTrue(scene.raycast(AHEAD, 3).isEmpty());
        assertEquals(8, scene.raycast(AHEAD, 4).orElseThrow().tag());
        scene.setParent(two.get(0), model, true);
        scene.setTransform(model, Transform.at(UP));
        assertEquals(model, scene.getInfo(two.get(0)).parent());
        Batch<Integer> ids = Batch.ints(model, two.get(0));
        assertEquals(List.of(new Transform(UP, STILL, 1), IDENTITY), scene.getTransforms(ids));
        assertEquals(1, scene.getWorldTransforms(ids).get(1).position().y(), 0);
        scene.setTransforms(ids, Batch.copyOf(Transform.LAYOUT, List.of(IDENTITY, IDENTITY)));
        assertEquals(0, scene.getWorldTransforms(ids).get(1).position().y(), 0);
        scene.validate();
        scene.removeSubtree(model);
        assertFalse(scene.has(two.get(0)));
        scene.remove(two.get(1));
        scene.removeBatch(scene.addBatch(Shapes.of(List.of(BALL, BALL, BALL))));
        assertTrue(scene.getSceneBounds().isEmpty());
        scene.add(BALL);
        scene.rebuildOctree();
        assertTrue(scene.maintainOctree(1000));
        scene.setWorkerCount(2);
        assertEquals(2, scene.getWorkerCount());
        scene.clear();
        assertEquals(0, scene.getModels().size());
        scene.setOrigin(new double[] {1e9 + 0.5, 0, 0});
        assertArrayEquals(new double[] {1e9 + 0.5, 0, 0}, scene.getOrigin(), 0);
    }

    static List<List<Integer>> readBack(Scene scene, Batch<Integer> models) {
        return models.stream().map(scene::getInfo).map(info -> List.of(info.parent(), info.layers(), info.tag())).toList();
    }

    @Test
    public void modelsWithDescsOfTheirOwn() {
        Scene scene = new Scene();
        int root = scene.add(BALL);
        Shapes three = Shapes.of(List.of(BALL, BALL, BALL));
        ModelDesc first = new ModelDesc().parent(root).layers(2).tag(5);
        Batch<ModelDesc> some = Batch.copyOf(ModelDesc.LAYOUT, List.of(first, new ModelDesc().tag(6), new ModelDesc()));
        List<List<Integer>> known = List.of(List.of(root, 2, 5), List.of(0, 1, 6), List.of(0, 1, 0));
        assertEquals(known, readBack(scene, scene.addDescribedBatch(three, null, some)));
        assertEquals(known, readBack(scene, scene.addDescribedBatch(Shapes.of(BALL), null, some)));
        Batch<ModelDesc> one = Batch.shared(ModelDesc.LAYOUT, first);
        assertEquals(Collections.nCopies(3, known.get(0)), readBack(scene, scene.addDescribedBatch(three, null, one)));
        assertEquals(Collections.nCopies(3, known.get(2)), readBack(scene, scene.addDescribedBatch(three)));
        assertEquals(6, some.get(1).tag());
        int count = scene.getModels().size();
        assertThrows(IllegalArgumentException.class, () -> scene.addDescribedBatch(three, null, some.first(2)));
        assertFails(ERROR_STRUCT_SIZE, () -> scene.addDescribedBatch(three, null, Batch.allocate(ModelDesc.LAYOUT, 3)));
        some.set(2, new ModelDesc().parent(12345));
        assertFails(ERROR_INVALID_ID, () -> scene.addDescribedBatch(three, null, some));
        assertEquals(count, scene.getModels().size());
    }

    static Hit orMiss(java.util.Optional<Hit> hit, Hit batched) {
        assertEquals(hit.isEmpty(), batched.model() == 0);
        return hit.orElse(batched);
    }

    @Test
    public void batchesAnswerAsSingleCallsDo() {
        Scene scene = new Scene();
        for (int i = 0; i < 30; ++i) scene.add(new Sphere(v(3 * Math.sin(i), 3 * Math.cos(2 * i), i / 3.0), 0.7f));
        int count = 200, met = 0;
        Vec3 start = v(0, 0, -5);
        Batch<Vec3> directions = Batch.allocate(Vec3.LAYOUT, count);
        Batch<Ray> rays = Batch.allocate(Ray.LAYOUT, count);
        Batch<Segment> segments = Batch.allocate(Segment.LAYOUT, count);
        Batch<Sphere> spheres = Batch.allocate(Sphere.LAYOUT, count);
        for (int i = 0; i < count; ++i) {
            Vec3 d = v(Math.sin(i) / 2, Math.cos(3 * i) / 2, 1);
            directions.set(i, d);
            rays.set(i, new Ray(start, d, Float.POSITIVE_INFINITY));
            segments.set(i, new Segment(start, v(10 * d.x(), 10 * d.y(), 5)));
            spheres.set(i, new Sphere(start, 0.2f));
        }
        Batch<Hit> hits = scene.raycastBatch(rays), tested = scene.segmentTestBatch(segments);
        Batch<Hit> swept = scene.sweepSphereBatch(spheres, directions);
        Batch<Nearest> nearest = scene.nearestBatch(directions);
        Batch<Integer> any = scene.raycastAnyBatch(rays);
        Ragged<Hit> all = scene.raycastAllBatch(rays);
        Batch<Distance> distances = scene.raycastDistanceBatch(rays);
        for (int i = 0; i < count; ++i) {
            assertEquals(orMiss(scene.raycast(rays.get(i)), hits.get(i)), hits.get(i));
            assertEquals(orMiss(scene.segmentTest(segments.get(i)), tested.get(i)), tested.get(i));
            assertEquals(orMiss(scene.sweepSphere(spheres.get(i), directions.get(i)), swept.get(i)), swept.get(i));
            assertEquals(scene.nearest(directions.get(i)).orElseThrow(), nearest.get(i));
            assertEquals(scene.raycastAny(rays.get(i)), any.get(i) == 1);
            assertEquals(hits.get(i).t(), distances.get(i).t(), 0);
            assertEquals(hits.get(i).model(), distances.get(i).model());
            assertEquals(scene.raycastAll(rays.get(i)), all.get(i));
            met += any.get(i);
        }
        assertTrue(met > 0 && met < count);

        // The caller's own memory, in and out.
        ByteBuffer memory = ByteBuffer.allocateDirect(4 + 52 * count).order(ByteOrder.nativeOrder()).position(4);
        Batch<Hit> room = Batch.of(Hit.LAYOUT, memory);
        assertSame(room, scene.raycastBatch(Batch.of(Ray.LAYOUT, rays.buffer()), ALL_LAYERS, room));
        assertEquals(hits, room);
        assertEquals(hits.get(0).model(), memory.getInt(4));
    }

    @Test
    public void filtersHaveListsOfModelsAndBatchesAFilterForEach() {
        Scene scene = new Scene();
        int[] models = new int[4];
        for (int i = 0; i < 4; ++i) models[i] = scene.add(new Sphere(new Vec3(0, 0, 4 * i), 1));
        Ray ray = new Ray(new Vec3(0, 0, -5), new Vec3(0, 0, 1), Float.POSITIVE_INFINITY);
        Sphere near = new Sphere(new Vec3(0, 0, 2), 2);
        QueryFilterDesc none = new QueryFilterDesc().ignoredModels();
        for (QueryFilterDesc two : List.of(new QueryFilterDesc().ignoredModels(models[1], models[0]),
                new QueryFilterDesc().ignoredModels(scene.overlap(near)))) {
            System.gc();
            assertEquals(models[2], scene.raycastFiltered(ray, two).orElseThrow().model());
            assertEquals(List.of(models[2], models[3]), scene.overlapFiltered(new Sphere(ZERO, 50), two));
        }
        assertEquals(models[0], scene.raycastFiltered(ray, none).orElseThrow().model());
        Batch<Ray> rays = Batch.copyOf(Ray.LAYOUT, List.of(ray, ray, ray));
        Batch<QueryFilterDesc> each = Batch.copyOf(QueryFilterDesc.LAYOUT, List.of(none, new QueryFilterDesc().ignoredModel(models[0]),
                new QueryFilterDesc().ignoredModels(models[0], models[1])));
        System.gc(); // the batch keeps the lists
        Batch<Hit> hits = scene.raycastFilteredBatch(rays, each);
        for (int i = 0; i < 3; ++i) assertEquals(models[i], hits.get(i).model());
        assertEquals(models[2], scene.raycastFiltered(ray, each.get(2)).orElseThrow().model());
        assertEquals(models[2], scene.raycastFilteredBatch(rays, Batch.shared(QueryFilterDesc.LAYOUT, each.get(2))).get(0).model());
        assertEquals(models[0], scene.raycastFilteredBatch(rays, null).get(2).model());
        assertEquals(List.of(0, 2, 3, 3), scene.overlapFilteredBatch(Shapes.of(List.of(near, near, near)), each).offsets());
        assertThrows(IllegalArgumentException.class, () -> scene.raycastFilteredBatch(rays, each.first(2)));
    }

    @Test
    public void filtersLeaveOutModels() {
        Scene scene = new Scene();
        int body = scene.add(BALL);
        scene.add(BALL, new Transform(v(0, 0, 3), STILL, 1), new ModelDesc().parent(body));
        int target = scene.add(BALL, new Transform(v(0, 0, 10), STILL, 1));
        QueryFilterDesc filter = new QueryFilterDesc().ignoredModel(body).flags(Gamephys.FILTER_SUBTREE);
        Ray ray = new Ray(ZERO, v(0, 0, 1), Float.POSITIVE_INFINITY);
        Segment segment = new Segment(ZERO, v(0, 0, 20));
        Sphere moving = new Sphere(ZERO, 0.5f), large = new Sphere(ZERO, 50);
        Vec3 way = v(0, 0, 20);
        assertEquals(body, scene.raycastFiltered(ray).orElseThrow().model());
        assertEquals(target, scene.raycastFiltered(ray, filter).orElseThrow().model());
        assertEquals(target, scene.segmentTestFiltered(segment, filter).orElseThrow().model());
        assertEquals(target, scene.nearestFiltered(ZERO, Float.POSITIVE_INFINITY, filter).orElseThrow().model());
        assertEquals(target, scene.sweepSphereFiltered(moving, way, filter).orElseThrow().model());
        assertTrue(scene.raycastAnyFiltered(ray, filter));
        assertEquals(1, scene.raycastAllFiltered(ray, filter).size());
        assertEquals(List.of(target), scene.overlapFiltered(large, filter));
        Batch<Ray> rays = Batch.copyOf(Ray.LAYOUT, List.of(ray, ray));
        Batch<Segment> segments = Batch.copyOf(Segment.LAYOUT, List.of(segment, segment));
        Batch<Sphere> spheres = Batch.copyOf(Sphere.LAYOUT, List.of(moving, moving));
        assertEquals(target, scene.raycastFilteredBatch(rays, Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1).model());
        assertEquals(target, scene.segmentTestFilteredBatch(segments, Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1).model());
        assertEquals(target, scene.sweepSphereFilteredBatch(spheres, points(way, way), Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1).model());
        assertEquals(target, scene.nearestFilteredBatch(points(way, way), Float.POSITIVE_INFINITY, Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1).model());
        assertEquals(List.of(1, 1), scene.raycastAnyFilteredBatch(rays, Batch.shared(QueryFilterDesc.LAYOUT, filter)));
        assertEquals(target, scene.raycastDistanceFilteredBatch(rays, Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1).model());
        assertEquals(List.of(0, 1, 2), scene.raycastAllFilteredBatch(rays, Batch.shared(QueryFilterDesc.LAYOUT, filter)).offsets());
        assertEquals(List.of(target), scene.overlapFilteredBatch(Shapes.of(List.of(large, large)), Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1));
        Camera camera = new Camera();
        camera.lookAt(v(0, 0, -10), ZERO, UP);
        assertEquals(target, camera.pickFiltered(scene, 400, 300, filter).orElseThrow().model());
        assertEquals(target, camera.pickFilteredBatch(scene, Batch.floats(400, 300, 1, 1), Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(0).model());
        assertEquals(List.of(target), camera.pickRectangleFiltered(scene, 0, 0, 800, 600, filter));
        assertEquals(List.of(target), camera.cullFiltered(scene, filter));
        assertEquals(List.of(target), scene.cullFiltered(camera.getFrustum(), filter));
        Batch<Frustum> views = Batch.copyOf(Frustum.LAYOUT, List.of(camera.getFrustum(), camera.getFrustum()));
        assertEquals(List.of(0, 3, 6), scene.cullBatch(views).offsets());
        assertEquals(List.of(target), scene.cullFilteredBatch(views, Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1));
    }

    @Test
    public void solidsMoveUpToWhatTheyTouchAndOutOfWhatTheyOverlap() {
        Sphere centred = new Sphere(ZERO, 1);
        assertEquals(0.5, sweep(centred, new Sphere(v(0, 4, 0), 1), v(0, -4, 0)).orElseThrow().t(), 0);
        assertEquals(0.5, penetration(centred, new Sphere(v(0, 0, 1.5f), 1)).orElseThrow().depth(), 0);
        Scene scene = new Scene();
        scene.add(centred);
        int target = scene.add(centred, new Transform(v(0, 0, 10), STILL, 1));
        QueryFilterDesc filter = new QueryFilterDesc().ignoredModel(target);
        Sphere moving = new Sphere(v(0, 0, 5), 1), deep = new Sphere(v(0, 0, 8.5f), 1);
        Vec3 way = v(0, 0, 6);
        Batch<Sphere> spheres = Batch.copyOf(Sphere.LAYOUT, List.of(moving, moving));
        assertEquals(target, scene.sweep(moving, way).orElseThrow().model());
        assertTrue(scene.sweepFiltered(moving, way, filter).isEmpty());
        assertEquals(target, scene.sweepBatch(Shapes.of(spheres), points(way, way)).get(1).model());
        assertEquals(0, scene.sweepFilteredBatch(Shapes.of(spheres), points(way, way), Batch.shared(QueryFilterDesc.LAYOUT, filter)).get(1).model());
        assertEquals(0.5, scene.penetration(deep).get(0).depth(), 0);
        assertEquals(0, scene.penetrationFiltered(deep, filter).size());
        Shapes crowd = Shapes.of(List.of(deep, moving));
        assertEquals(List.of(0, 1, 1), scene.penetrationBatch(crowd).offsets());
        assertEquals(target, scene.penetrationBatch(crowd).get(0).get(0).model());
        assertEquals(List.of(0, 0, 0), scene.penetrationFilteredBatch(crowd, Batch.shared(QueryFilterDesc.LAYOUT, filter)).offsets());
        Sphere above = new Sphere(v(0, 4, 0), 1), inside = new Sphere(v(0, 0, 1.5f), 1);
        Batch<Hit> hits = sweepBatch(Shapes.of(centred), Shapes.of(List.of(above, inside)), points(v(0, -4, 0), v(0, -4, 0)));
        assertEquals(0.5, hits.get(0).t(), 0);
        assertEquals(0, hits.get(1).t(), 0);
        Batch<Penetration> outs = penetrationBatch(Shapes.of(centred), Shapes.of(List.of(inside, above)));
        assertEquals(0.5, outs.get(0).depth(), 0);
        assertEquals(Float.NEGATIVE_INFINITY, outs.get(1).depth(), 0);
    }

    @Test
    public void shapesChangeAndTreesAndCamerasAreRead() {
        Scene scene = new Scene();
        int body = scene.add(BALL), head = scene.add(BALL, null, new ModelDesc().parent(body));
        scene.setShape(body, new Sphere(ZERO, 5));
        assertEquals(5, scene.getBounds(body).orElseThrow().max().x(), 0);
        scene.setScale(body, new Vec3(2, 2, 2));
        assertEquals(10, scene.getBounds(body).orElseThrow().max().x(), 0);
        assertEquals(2, scene.getScale(body).y(), 0);
        assertEquals(List.of(body), scene.getRoots());
        assertEquals(List.of(head), scene.getChildren(body));
        Camera camera = new Camera();
        camera.setOrthographic(10, 1, 100);
        camera.setViewport(200, 100);
        assertEquals(new Camera.ProjectionResult(Gamephys.PROJECTION_ORTHOGRAPHIC, 10, 1, 100), camera.getProjection());
        assertEquals(new Camera.ViewportResult(200, 100), camera.getViewport());
    }

    @Test
    public void camerasSeeByAspectInAWindowFromTheNearPlaneOn() {
        Camera camera = new Camera();
        camera.setPerspectiveAspect(1, 2, 1, 100);
        assertEquals(new Camera.AspectResult(2, true), camera.getAspect());
        assertEquals(new Camera.ConventionsResult(Gamephys.LEFT_HANDED, Gamephys.DEPTH_ZERO_TO_ONE, false), camera.getConventions());
        camera.setOrthographicSize(8, 6, 1, 100);
        assertEquals(new Camera.ImageSizeResult(8, 6), camera.getImageSize());
        camera.setViewportOrigin(800, 0);
        assertEquals(new Camera.ViewportOriginResult(800, 0), camera.getViewportOrigin());
        camera.setPerspective(1, 1, 100);
        assertEquals(1, camera.pickRay(1200, 300).orElseThrow().origin().z(), 0);
        camera.setPickStart(Gamephys.PICK_FROM_CENTRE);
        assertEquals(Gamephys.PICK_FROM_CENTRE, camera.getPickStart());
        assertEquals(0, camera.pickRay(1200, 300).orElseThrow().origin().z(), 0);
        Mat4 view = camera.getViewMatrix();
        camera.setViewMatrix(view);
        assertEquals(0, mat4Orthonormality(view), 0);
        assertEquals(camera.getCorners(), camera.getRectangleCorners(800, 0, 1600, 600));
        assertEquals(ZERO, camera.getRectangleFrustum(800, 0, 1200, 600).origin());
        camera.setOrbit(defaultOrbit());
        OrbitSpeeds speeds = new OrbitSpeeds(0.5f, 1, 2, 3, 4);
        camera.setOrbitSpeeds(speeds);
        assertEquals(speeds, camera.getOrbitSpeeds());
        Plane x1 = new Plane(v(1, 0, 0), 1), y2 = new Plane(UP, 2), z3 = new Plane(v(0, 0, 1), 3);
        assertEquals(v(1, 2, 3), planesIntersection(x1, y2, z3).orElseThrow());
        assertTrue(planesIntersection(x1, y2, y2).isEmpty());
        Batch<Plane> last = Batch.copyOf(Plane.LAYOUT, List.of(z3, y2));
        Batch<Vec3> points = planesIntersectionBatch(Batch.copyOf(Plane.LAYOUT, List.of(x1, x1)),
            Batch.copyOf(Plane.LAYOUT, List.of(y2, y2)), last);
        assertEquals(v(1, 2, 3), points.get(0));
    }

    @Test
    public void aMeshDeformsAndItsModelsWithIt() {
        Mesh mesh = new Mesh(Batch.floats(0, 0, 0, 1, 0, 0, 0, 1, 0), Batch.ints(0, 1, 2), new MeshDesc().deformable(1));
        Scene scene = new Scene();
        int model = scene.add(mesh);
        mesh.setVertices(Batch.floats(0, 0, 7, 1, 0, 7, 0, 1, 7));
        assertEquals(7, scene.getBounds(model).orElseThrow().min().z(), 1e-3);
        assertEquals(new MeshInfo(Gamephys.MESH_SURFACE, 3, 1, 1, 0), mesh.getInfo());
        // The mesh of a restored scene, met from behind, or not.
        Scene copy = new Scene();
        copy.restore(null, scene.getSnapshot(true));
        assertEquals(new MeshInfo(Gamephys.MESH_SURFACE, 3, 1, 0, 0), new Mesh(copy, model).getInfo());
        Ray fromBehind = new Ray(v(0.2f, 0.2f, 0), v(0, 0, 1), Float.POSITIVE_INFINITY);
        QueryFilterDesc filter = new QueryFilterDesc().flags(Gamephys.FILTER_NO_FRONT_FACES);
        assertEquals(Gamephys.HIT_BACK, copy.raycastFiltered(fromBehind, filter).orElseThrow().flags());
        assertTrue(copy.raycastFiltered(fromBehind, filter.flags(Gamephys.FILTER_NO_BACK_FACES)).isEmpty());
    }

    @Test
    public void aHullIsASolidMesh() {
        Mesh hull = Mesh.hull(Batch.floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1f, 0.1f, 0.1f));
        assertEquals(4, hull.getVertices().size());
        assertEquals(4, hull.getHullPlanes().size());
        assertEquals(4, hull.getHullFaces().size());
    }

    @Test
    public void aRopeIsPickedAsAModelThatFollowsIt() {
        Solver solver = new Solver();
        int rope = solver.addRope(points(v(0, 0, 0), v(1, 0, 0), v(2, 0, 0)), 0);
        Scene scene = new Scene();
        int model = scene.add(new Mesh(solver, rope));
        solver.setPositions(rope, 0, points(v(0, 0, 7), v(1, 0, 7), v(2, 0, 7)));
        Hit hit = scene.raycast(new Ray(v(1.8f, 0, 0), v(0, 0, 1), Float.POSITIVE_INFINITY)).orElseThrow();
        assertEquals(model, hit.model());
        assertEquals(1, hit.triangle());
        assertEquals(2, solver.getNearestParticle(rope, hit.triangle(), hit.point()));
    }

    @Test
    public void listsOfAnyLength() {
        Scene scene = new Scene();
        Batch<Integer> models = scene.addBatch(Shapes.of(Batch.allocate(Sphere.LAYOUT, 500))); // more than the first guess has room for
        assertEquals(models, scene.getModels());
        Ragged<Integer> found =
                scene.overlapBatch(Shapes.of(List.of(new Aabb(v(-1, -1, -1), v(1, 1, 1)), new Aabb(v(5, 5, 5), v(6, 6, 6)))));
        assertEquals(List.of(0, 500, 500), found.offsets());
        assertEquals(models, found.get(0));
        assertEquals(List.of(), found.get(1));
        assertEquals(0, scene.overlap(BALL).size());
        assertEquals(500, scene.raycastAll(AHEAD).size());
        assertEquals(500, scene.getOctreeStats().itemCount());
        assertTrue(scene.getOctreeBoxes().size() > 1);
    }

    @Test
    public void cameras() {
        Camera camera = new Camera();
        camera.lookAt(v(0, 0, -10), ZERO, UP);
        camera.setPerspective(1, 0.1f, 100);
        Vec3 pixel = camera.project(ZERO).orElseThrow();
        assertVector(v(400, 300, pixel.z()), pixel, 1e-2);
        assertTrue(camera.project(v(0, 0, -20)).isEmpty());
        Batch<Vec3> pixels = camera.projectBatch(points(ZERO, v(1, 1, 1)));
        assertVector(v(1, 1, 1), camera.unprojectBatch(pixels).get(1), 1e-2);
        assertVector(v(1, 1, 1), camera.unproject(pixels.get(1)).orElseThrow(), 1e-2);
        assertVector(v(0, 0, 1), camera.pickRay(400, 300).orElseThrow().direction(), 1e-5);
        assertEquals(12, camera.pickRays(0, 0, 4, 3).size());

        Scene scene = new Scene();
        int model = scene.add(BALL);
        assertEquals(model, camera.pick(scene, 400, 300).orElseThrow().model());
        assertTrue(camera.pick(scene, 1, 1).isEmpty());
        assertEquals(0, camera.pickBatch(scene, Batch.floats(400, 300, 1, 1)).get(1).model());
        assertEquals(List.of(model), camera.pickRectangle(scene, 0, 0, 800, 600));
        assertEquals(List.of(model), camera.cull(scene));
        assertEquals(List.of(model), scene.cull(camera.getFrustum()));

        camera.setViewport(200, 100);
        camera.setOrthographic(10, 0.1f, 100);
        Mat4 projection = camera.getProjectionMatrix();
        assertEquals(0.2, projection.m().get(5), 1e-6);
        camera.setProjection(projection);
        assertEquals(-10, camera.getWorldMatrix().m().get(14), 0);
        assertEquals(10, camera.getViewMatrix().m().get(14), 1e-5);
        camera.setWorldMatrix(new Mat4(List.of(1f, 0f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 0f, 1f, 0f, 4f, 5f, 6f, 1f)));
        assertEquals(new Camera.TransformResult(v(4, 5, 6), STILL), camera.getTransform());
        camera.setTransform(v(1, 2, 3), new Quat(0, 1, 0, 0));
        assertEquals(v(1, 2, 3), camera.getTransform().position());
        camera.setOrigin(new double[] {1, 0, 0});
        assertEquals(1, camera.getOrigin()[0], 0);
    }

    @Test
    public void orbit() {
        Camera camera = new Camera();
        assertFails(ERROR_UNSUPPORTED, camera::getOrbit);
        camera.setOrbit(defaultOrbit());
        camera.orbitRotate(0.5f, 0.25f);
        camera.orbitZoom(1);
        camera.orbitPan(2, 0);
        camera.orbitUpdate();
        Orbit orbit = camera.getOrbit();
        assertVector(v(0.5, 0.25, 9), v(orbit.yaw(), orbit.pitch(), orbit.distance()), 1e-5);
        assertEquals(2, Math.abs(orbit.target().x()), 1e-3);
    }

    @Test
    public void particles() {
        Scene scene = new Scene();
        Solver solver = new Solver(new SolverDesc().substeps(4).gravity(v(0, -1, 0)));
        solver.setGravity(v(0, -10, 0));
        solver.setSubsteps(5);
        int free = solver.addParticles(points(v(0, 5, 0), v(1, 5, 0)));
        solver.setVelocities(free, 1, points(v(3, 0, 0)));
        solver.step(scene, 0.1f);
        assertVector(v(0, -1, 0), solver.getVelocities(free, 0, 1).get(0), 1e-5);
        assertVector(v(1.3, 4.95, 0), solver.getPositions(free, 1, 1).get(0), 1e-5);
        solver.setMasses(free, 0, Batch.floats(2, 4));
        assertEquals(List.of(2f, 4f), solver.getMasses(free, 0, 2));
        solver.setForces(free, 0, points(v(0, 20, 0), v(0, 40, 0))); // weightless
        solver.step(null, 0.1f);
        assertVector(v(0, -1, 0), solver.getVelocities(free, 0, 1).get(0), 1e-5);

        int plane = scene.add(new Plane(UP, 0));
        solver.setRadii(free, 0, Batch.floats(0.5f, 0.5f));
        solver.setPositions(free, 0, points(v(0, 0.6, 0), v(9, 0.6, 0)));
        solver.setForces(free, 0, points(ZERO, ZERO));
        for (int i = 0; i < 30; ++i) solver.step(scene, 0.02f);
        assertEquals(0.5, solver.getPositions(free, 0, 1).get(0).y(), 1e-3);
        Batch<Contact> contacts = solver.getContacts();
        assertEquals(2, contacts.size());
        assertEquals(plane, contacts.get(0).model());
        assertEquals(UP, contacts.get(0).normal());
        solver.setOrigin(new double[] {0, 1, 0});
        assertEquals(1, solver.getOrigin()[1], 0);
        assertEquals(-0.5, solver.getPositions(free, 0, 1).get(0).y(), 1e-3);
    }

    @Test
    public void ropeAndCloth() {
        Scene scene = new Scene();
        Solver solver = new Solver();
        int rope = solver.addRope(points(v(0, 8, 0), v(1, 8, 0), v(2, 8, 0)), 0, new BodyDesc().mass(3));
        assertEquals(BODY_ROPE, solver.getBodyInfo(rope).kind());
        solver.setPinned(rope, 0, 1, true);
        int tie = solver.addDistance(rope, 0, 2, -1);
        assertEquals(new ConstraintInfo(tie, 0, 2, 2, 0), solver.getConstraints(rope).get(2));
        solver.removeConstraint(rope, tie);
        assertEquals(2, solver.getConstraints(rope).size());
        int hook = scene.add(new Sphere(ZERO, 0.1f), new Transform(v(0, 8, 0), STILL, 1), new ModelDesc().layers(2));
        solver.attach(scene, rope, 0, hook, ZERO);
        scene.setTransform(hook, new Transform(v(0, 9, 0), STILL, 1));
        Solver.AdvanceResult advanced = solver.advance(scene, 0.025f);
        assertEquals(1, advanced.steps());
        assertEquals(0.5, advanced.leftover(), 1e-5);
        assertEquals(8 + 2 / 3.0, solver.getPositions(rope, 0, 1).get(0).y(), 1e-5);
        assertEquals(1, solver.getStats(rope).pinnedCount());
        solver.detach(rope, 0);
        assertFails(ERROR_INVALID_ARGUMENT, () -> solver.detach(rope, 0));

        int cloth = solver.addCloth(v(0, 3, 0), v(1, 0, 0), v(0, 0, 1), 3, 3);
        assertEquals(24, solver.getTriangles(cloth).size());
        int shirt = solver.addClothMesh(pyramid(), IDENTITY);
        assertEquals(5, solver.getBodyInfo(shirt).particleCount());
        solver.removeBody(cloth);
        assertEquals(List.of(rope, shirt), solver.getBodies());

        Batch<Integer> snapshot = solver.getSnapshot();
        int[] then = solver.getHash();
        solver.step(scene, 0.01f);
        assertFalse(Arrays.equals(then, solver.getHash()));
        solver.restore(snapshot);
        assertArrayEquals(then, solver.getHash());
        Scene copy = new Scene();
        copy.restore(null, scene.getSnapshot(true));
        assertArrayEquals(scene.getHash(), copy.getHash());
        copy.restore(scene, scene.getSnapshot(false));
        assertArrayEquals(scene.getHash(), copy.getHash());
        solver.wake(0);
        assertEquals(List.of(), solver.getSleeping());
    }

    @Test
    public void substepsAreAsManyAsAskedForOrAsATargetTakes() {
        int[] substeps = new int[2];
        for (int i = 0; i < 2; ++i) {
            Solver solver = new Solver(new SolverDesc().maxStrain(i * 1e-6f));
            int cloth = solver.addCloth(ZERO, v(1, 0, 0), v(0, 0, 1), 3, 3);
            solver.setPinned(cloth, 0, 1, true);
            assertEquals(0, solver.getSubsteps(cloth));
            for (int step = 0; step < 5; ++step) solver.step(null, 0.01f);
            substeps[i] = solver.getSubsteps(cloth);
        }
        assertEquals(8, substeps[0]);
        assertTrue(substeps[1] > 8);
    }

    @Test
    public void aStringHoldsAWeightAndAPyramidKeepsItsVolume() {
        Scene scene = new Scene();
        Solver solver = new Solver();
        int hook = scene.add(new Sphere(ZERO, 0.1f), null, new ModelDesc().tag(5));
        int weights = solver.addParticles(points(ZERO, v(0, -1, 0)), new BodyDesc().mass(2).layers(0));
        solver.attach(scene, weights, 0, hook, ZERO);
        int string = solver.addMaxDistance(weights, 0, 1, 2, 1e-6f);
        solver.setConstraintDamping(weights, string, 50);
        assertEquals(List.of(Gamephys.CONSTRAINT_MAX_DISTANCE), solver.getConstraintKinds(weights, Batch.ints(string)));
        assertEquals(hook, solver.getAttachments(weights).get(0).model());
        for (int step = 0; step < 300; ++step) solver.step(scene, 0.01f);
        assertEquals(-2, solver.getPositions(weights, 1, 1).get(0).y(), 1e-3);
        Batch<Impulse> impulses = solver.getImpulses();
        assertEquals(1, impulses.size());
        assertEquals(hook, impulses.get(0).model());
        assertEquals(5, impulses.get(0).tag());
        assertEquals(-2 * 9.81 * 0.01, impulses.get(0).linear().y(), 5e-3);
        int ball = solver.addClothMesh(pyramid(), IDENTITY);
        solver.setVolume(ball, -1, 0);
        assertEquals(8.0 / 3, solver.getVolume(ball).volume(), 1e-5);
        assertEquals(0, solver.getVolume(ball).pressure(), 0);
        assertEquals(new Solver.VolumeSettingsResult(solver.getVolume(ball).volume(), 0), solver.getVolumeSettings(ball));
        solver.setVolume(ball, 1, Float.POSITIVE_INFINITY);
        assertFails(ERROR_UNSUPPORTED, () -> solver.getVolume(ball));
    }

    @Test
    public void settingsChangeLive() {
        Solver solver = new Solver();
        SolverSettings s = solver.getSettings();
        solver.setSettings(new SolverSettings(
                s.gravity(), 5, s.fixedStep(), s.maxSteps(), s.sleepSpeed(), s.sleepStrain(), s.sleepTime(),
                s.maxStrain(), s.tolerance(), s.maxSubsteps(), s.maxWork()));
        assertEquals(5, solver.getSettings().substeps());
        solver.setWorkerCount(2);
        assertEquals(2, solver.getWorkerCount());
        assertEquals(0, solver.getLeftover(), 0);
        int rope = solver.addRope(points(ZERO, v(0, -1, 0)), 0);
        solver.setPinned(rope, 0, 1, true);
        assertEquals(List.of(1, 0), solver.getPinned(rope, 0, 2));
        BodySettings b = solver.getBodySettings(rope);
        solver.setBodySettings(rope, new BodySettings(
                0.5f, b.friction(), b.staticFriction(), b.restitution(), b.layers(), b.bodyLayers(), b.selfCollision()));
        assertEquals(0.5, solver.getBodySettings(rope).damping(), 0);
        Batch<Integer> links = Batch.ints(solver.getConstraints(rope).get(0).id());
        Batch<ConstraintSettings> link = solver.getConstraintSettings(rope, links);
        assertEquals(1, link.get(0).restLength(), 0);
        link.set(0, new ConstraintSettings(0.5f, 0, 0));
        solver.setConstraintSettings(rope, links, link);
        assertEquals(0.01f, solver.getRadii(rope, 0, 2).get(1), 0);
        assertEquals(ZERO, solver.getForces(rope, 0, 2).get(1));
        for (int step = 0; step < 10; ++step) solver.step(null, 0.01f);
        assertEquals(-0.5, solver.getPositions(rope, 1, 1).get(0).y(), 1e-5);
    }

    @Test
    public void windCarriesBallsAlong() {
        Solver solver = new Solver(new SolverDesc().gravity(ZERO));
        int balls = solver.addParticles(points(ZERO, v(1, 0, 0)));
        solver.setWind(balls, new Wind(v(2, 0, 0), 1e4f, 0.5f, 0));
        assertEquals(1e4, solver.getWind(balls).density(), 0);
        solver.setAirVelocities(balls, 1, points(v(0, 3, 0)));
        assertEquals(v(0, 3, 0), solver.getAirVelocities(balls, 0, 2).get(1));
        for (int step = 0; step < 500; ++step) solver.step(null, 0.01f);
        Batch<Vec3> speeds = solver.getVelocities(balls, 0, 2);
        assertTrue(speeds.get(0).x() > 1.8 && speeds.get(1).y() > 2.7);
    }

    @Test
    public void aClusterHoldsOutAParticleUntilItEnds() {
        Solver solver = new Solver();
        int plank = solver.addParticles(points(v(0, 0, 0), v(1, 0, 0), v(2, 0, 0)));
        solver.setPinned(plank, 0, 2, true);
        int cluster = solver.addCluster(plank, Batch.ints(0, 1, 2));
        assertEquals(List.of(cluster), solver.getClusters(plank));
        assertEquals(List.of(0, 1, 2), solver.getClusterParticles(plank, cluster));
        for (int step = 0; step < 30; ++step) solver.step(null, 0.01f);
        assertEquals(2, solver.getPositions(plank, 2, 1).get(0).x(), 1e-5);
        assertEquals(0, solver.getPositions(plank, 2, 1).get(0).y(), 1e-5);
        solver.removeCluster(plank, cluster);
        for (int step = 0; step < 30; ++step) solver.step(null, 0.01f);
        assertTrue(solver.getPositions(plank, 2, 1).get(0).y() < -0.4);
        assertFails(ERROR_INVALID_ID, () -> solver.removeCluster(plank, cluster));
    }

    @Test
    public void aRopeBreaksUnderItsWeightAndClothIsCut() {
        Solver solver = new Solver();
        int rope = solver.addRope(points(ZERO, v(0, -1, 0)), 0);
        solver.setPinned(rope, 0, 1, true);
        Batch<Integer> links = Batch.ints(solver.getConstraints(rope).get(0).id());
        solver.setBreakingForces(rope, links, Batch.floats(3));
        assertEquals(3, solver.getBreakingForces(rope, links).get(0), 0);
        assertTrue(solver.getBreaks().isEmpty());
        for (int i = 0; i < 10 && solver.getBreaks().isEmpty(); ++i) solver.step(null, 0.01f);
        Break broken = solver.getBreaks().get(0);
        assertEquals(List.of(rope, links.get(0), NO_PARTICLE),
                List.of(broken.body(), broken.constraint(), broken.tornParticle()));
        assertTrue(broken.load() > 3);
        assertFails(ERROR_INVALID_ID, () -> solver.breakConstraint(rope, links.get(0)));
        int sheet = solver.addCloth(ZERO, v(1, 0, 0), v(0, 0, 1), 3, 3);
        assertEquals(9, solver.breakConstraint(sheet, solver.getConstraints(sheet).get(1).id()).newParticle());
    }

    @Test
    public void oneOfTwoBallsSlidesOverIce() {
        Solver solver = new Solver();
        Scene scene = new Scene();
        scene.add(new Plane(v(0, 1, 0), 0));
        int balls = solver.addParticles(points(v(0, 0.01f, 0), v(0, 0.01f, 1)));
        solver.setFrictionFactors(balls, 1, Batch.floats(0));
        assertEquals(1, solver.getFrictionFactors(balls, 0, 2).get(0), 0);
        assertEquals(0, solver.getFrictionFactors(balls, 0, 2).get(1), 0);
        solver.setVelocities(balls, 0, points(v(1, 0, 0), v(1, 0, 0)));
        for (int step = 0; step < 50; ++step) solver.step(scene, 0.01f);
        Batch<Vec3> speeds = solver.getVelocities(balls, 0, 2);
        assertEquals(0, speeds.get(0).x(), 0);
        assertEquals(1, speeds.get(1).x(), 1e-5);
    }

    @Test
    public void aBallPressesTheOneThatItLiesOn() {
        Solver solver = new Solver();
        BodyDesc desc = new BodyDesc().mass(2).radius(0.5f).bodyLayers(1);
        int lower = solver.addParticles(points(ZERO), desc), upper = solver.addParticles(points(UP), desc);
        solver.setPinned(lower, 0, 1, true);
        for (int step = 0; step < 20; ++step) solver.step(null, 0.01f);
        Batch<BodyContact> contacts = solver.getBodyContacts();
        assertEquals(1, contacts.size());
        assertEquals(List.of(lower, upper), List.of(contacts.get(0).bodyA(), contacts.get(0).bodyB()));
        assertEquals(UP, contacts.get(0).normal());
        assertEquals(0.1962, contacts.get(0).impulse(), 2e-3);
    }

    @Test
    public void aBallHangsBelowItsAnimationTarget() {
        Solver solver = new Solver();
        int balls = solver.addParticles(points(ZERO, v(1, 0, 0)));
        Batch<AnimationTarget> targets = solver.getAnimationTargets(balls, 1, 1);
        assertEquals(Float.POSITIVE_INFINITY, targets.get(0).maxDistance(), 0);
        targets.set(0, new AnimationTarget(v(1, 0, 0), ZERO, 0.25f, Float.POSITIVE_INFINITY));
        solver.setAnimationTargets(balls, 1, targets);
        for (int step = 0; step < 60; ++step) solver.step(null, 0.01f);
        assertEquals(-0.25, solver.getPositions(balls, 1, 1).get(0).y(), 0);
    }

    @Test
    public void aJointHoldsAParticleOfAnotherBody() {
        Solver solver = new Solver();
        int nail = solver.addParticles(points(ZERO), new BodyDesc().mass(2));
        int weight = solver.addParticles(points(v(0, -1, 0)), new BodyDesc().mass(2));
        solver.setPinned(nail, 0, 1, true);
        int joint = solver.join(nail, 0, weight, 0, -1);
        for (int step = 0; step < 20; ++step) solver.step(null, 0.01f);
        Batch<JointInfo> joints = solver.getJoints(weight);
        assertEquals(1, joints.size());
        assertEquals(joint, joints.get(0).id());
        assertEquals(weight, joints.get(0).bodyB());
        assertEquals(2 * 9.81, joints.get(0).force(), 0.01);
        solver.unjoin(joint);
        assertEquals(0, solver.getJoints(0).size());
        assertFails(ERROR_INVALID_ID, () -> solver.unjoin(joint));
    }

    @Test
    public void errorsHaveTheLibrarysMessage() {
        Scene scene = new Scene();
        assertTrue(assertFails(ERROR_INVALID_ARGUMENT, () -> scene.add(new Sphere(ZERO, -1))).contains("radius"));
        assertFails(ERROR_INVALID_ID, () -> scene.remove(12345));
        assertFails(ERROR_UNSUPPORTED, () -> transform(pyramid(), IDENTITY));
        int model = scene.add(pyramid());
        assertFails(ERROR_UNSUPPORTED, () -> scene.getShape(model));
        Batch<Ray> one = Batch.allocate(Ray.LAYOUT, 1);
        assertThrows(IllegalArgumentException.class, () -> scene.raycastBatch(one, 1, Batch.allocate(Hit.LAYOUT, 2)));
        assertThrows(IllegalArgumentException.class, () -> scene.sweepSphereBatch(Batch.allocate(Sphere.LAYOUT, 2), points(UP)));
        assertThrows(IllegalArgumentException.class, () -> Batch.of(Ray.LAYOUT, ByteBuffer.allocateDirect(30)));
        assertThrows(IllegalArgumentException.class, () -> Batch.of(Ray.LAYOUT, ByteBuffer.allocate(28)));
        assertThrows(IllegalArgumentException.class, () -> Batch.of(Ray.LAYOUT, ByteBuffer.allocateDirect(29).position(1)));
        assertThrows(IllegalArgumentException.class, () -> Shapes.of(List.of(BALL, new Plane(UP, 0))));
        assertThrows(IllegalArgumentException.class, () -> new Mesh(Batch.floats(0, 0), Batch.ints()));
        assertThrows(IllegalArgumentException.class, () -> scene.setOrigin(new double[2]));
        assertThrows(IndexOutOfBoundsException.class, () -> one.get(1));
        assertEquals("GPHYS_NO_HIT", statusName(NO_HIT));
        assertTrue(version().matches("\\d+\\.\\d+\\.\\d+"));
    }

    @Test
    public void useAfterCloseIsAnException() {
        Scene scene = new Scene();
        Mesh mesh = pyramid();
        scene.add(mesh);
        mesh.close();
        mesh.close();
        assertThrows(IllegalStateException.class, () -> scene.add(mesh));
        assertThrows(IllegalStateException.class, () -> Shapes.of(mesh));
        Mesh other = pyramid();
        Shapes shapes = Shapes.of(other);
        other.close();
        assertThrows(IllegalStateException.class, () -> overlapsBatch(shapes, Shapes.of(List.of(BALL))));
        assertThrows(IllegalStateException.class, () -> raycast(mesh, AHEAD));
        assertTrue(scene.raycast(new Ray(v(0.1, 5, 0.1), v(0, -1, 0), 10)).isPresent()); // the model holds it
        scene.close();
        assertThrows(IllegalStateException.class, scene::getModels);
        assertThrows(IllegalStateException.class, () -> new Camera().pick(scene, 0, 0));
    }

    public interface Allocate extends Callback {
        Pointer call(Pointer user, long size, long alignment);
    }

    public interface Release extends Callback {
        void call(Pointer user, Pointer memory, long size, long alignment);
    }

    /** The functions of an allocator see what is taken and given back. */
    @Test
    public void theCollectorFrees() throws InterruptedException {
        Map<Pointer, Memory> taken = new ConcurrentHashMap<>();
        Allocate allocate = (user, size, alignment) -> {
            Memory memory = new Memory(size + alignment);
            Pointer start = memory.align((int) alignment);
            taken.put(start, memory);
            return start;
        };
        Release release = (user, memory, size, alignment) -> taken.remove(memory);
        Memory allocator = new Memory(3L * Native.POINTER_SIZE);
        allocator.setPointer(0, CallbackReference.getFunctionPointer(allocate));
        allocator.setPointer(Native.POINTER_SIZE, CallbackReference.getFunctionPointer(release));
        allocator.setPointer(2L * Native.POINTER_SIZE, null);
        pyramid(new MeshDesc().allocator(allocator)).close();
        assertEquals(Map.of(), taken);
        for (int i = 0; i < 10; ++i) new Scene(new SceneDesc().allocator(allocator)).add(BALL);
        assertFalse(taken.isEmpty());
        for (int i = 0; i < 500 && !taken.isEmpty(); ++i) { // the cleaner has a thread of its own
            System.gc();
            Thread.sleep(10);
        }
        assertEquals(Map.of(), taken);
        assertNotNull(allocate);
        assertNotNull(release);
    }

    /** A mesh that is closed while another thread asks about it goes when the call ends, on that thread. */
    @Test
    public void aCallHoldsTheMeshThatIsItsShape() throws InterruptedException {
        Map<Pointer, Memory> taken = new ConcurrentHashMap<>();
        AtomicBoolean asking = new AtomicBoolean(), freedMeanwhile = new AtomicBoolean();
        Thread[] asker = new Thread[1];
        Allocate allocate = (user, size, alignment) -> {
            Memory memory = new Memory(size + alignment);
            Pointer start = memory.align((int) alignment);
            taken.put(start, memory);
            return start;
        };
        Release release = (user, memory, size, alignment) -> {
            if (asking.get() && Thread.currentThread() != asker[0]) freedMeanwhile.set(true);
        };
        Memory allocator = new Memory(3L * Native.POINTER_SIZE);
        allocator.setPointer(0, CallbackReference.getFunctionPointer(allocate));
        allocator.setPointer(Native.POINTER_SIZE, CallbackReference.getFunctionPointer(release));
        allocator.setPointer(2L * Native.POINTER_SIZE, null);
        Batch<Ray> rays = Batch.copyOf(Ray.LAYOUT, Collections.nCopies(200_000, AHEAD));
        Batch<Hit> hits = Batch.allocate(Hit.LAYOUT, rays.size());
        Batch<Integer> yes = Batch.allocate(Layout.INT, rays.size());
        Shapes balls = Shapes.of(Batch.copyOf(Sphere.LAYOUT, Collections.nCopies(rays.size(), BALL)));
        for (boolean asShapes : new boolean[] {false, true}) {
            Mesh mesh = pyramid(new MeshDesc().allocator(allocator));
            Shapes shapes = Shapes.of(mesh);
            AtomicBoolean answered = new AtomicBoolean(); // unless it was closed before the call began
            asker[0] = new Thread(() -> {
                asking.set(true);
                try {
                    if (asShapes) overlapsBatch(balls, shapes, yes);
                    else raycastBatch(mesh, rays, hits);
                    answered.set(true);
                } catch (IllegalStateException closed) {
                    // nothing was asked
                }
                asking.set(false);
            });
            asker[0].start();
            while (!asking.get()) Thread.onSpinWait();
            Thread.sleep(5);
            mesh.close();
            asker[0].join();
            boolean freed = freedMeanwhile.getAndSet(false);
            assertFalse(answered.get() && freed);
        }
        assertNotNull(allocate);
        assertNotNull(release);
    }

    private static GamephysException refused(int triangles) {
        Batch<Integer> indices = Batch.allocate(Layout.INT, 3 * triangles);
        indices.set(3 * triangles - 1, 3);
        return assertThrows(GamephysException.class, () -> new Mesh(Batch.floats(0, 0, 0, 1, 0, 0, 0, 1, 0), indices));
    }

    /** Arrays that nothing but the call refers to: the last index is read before they are freed. */
    @Test
    public void theCollectorLeavesWhatACallReads() throws InterruptedException {
        for (int i = 0; i < 20000; ++i) refused(1); // interpreted code keeps what is in its variables
        AtomicBoolean done = new AtomicBoolean();
        Thread collector = new Thread(() -> {
            while (!done.get()) System.gc();
        });
        collector.start();
        for (int i = 0; i < 4; ++i) assertTrue(refused(2_000_000).getMessage().contains("indices[5999999] 3 is not"));
        done.set(true);
        collector.join();
    }

    @Test
    public void resultsDoNotGoIntoMemoryThatIsOnlyRead() {
        Batch<Integer> room = Batch.allocate(Layout.INT, 1), read = Batch.of(Layout.INT, room.buffer().asReadOnlyBuffer());
        Batch<Ray> rays = Batch.copyOf(Ray.LAYOUT, List.of(AHEAD));
        Scene scene = new Scene();
        scene.add(BALL);
        assertThrows(ReadOnlyBufferException.class, () -> scene.raycastAnyBatch(rays, ALL_LAYERS, read));
        assertEquals(0, (int) read.get(0));
    }

    /** Queries of one scene may run at once. */
    @Test
    public void threadsMayAskAtOnce() {
        Scene scene = new Scene();
        for (int i = 0; i < 100; ++i) scene.add(new Sphere(v(0, 0, 3 * i), 1));
        assertTrue(IntStream.range(0, 20000).parallel().allMatch(i -> {
            Ray ray = new Ray(v(0, 0, 3 * (i % 100) - 1.25), v(0, 0, 1), 100);
            return scene.raycast(ray).orElseThrow().t() == 0.25f;
        }));
        assertEquals(new ArrayList<>(scene.getModels()).size(), 100);
    }
}
