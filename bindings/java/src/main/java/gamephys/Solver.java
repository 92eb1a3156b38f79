// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.util.Optional;

/**
 * <pre>
 * Create a solver without bodies. With a worker_count of n, n threads share the bodies of a step; the
 * results have the same bits for every n. Threads are started, joined and lost as those of Scene.
 *   - desc: null: the defaults
 * Throws GamephysException with ERROR_OUT_OF_MEMORY also if the threads cannot be started.
 * Cost: O(1), and that of starting the threads.
 * </pre>
 */
public final class Solver extends Owned {
    public Solver(SolverDesc desc) {
        super(create(desc), Low::gphys_solver_destroy);
    }

    public Solver() {
        super(create((SolverDesc) null), Low::gphys_solver_destroy);
    }

    private static Pointer create(SolverDesc desc) {
        return Low.create(made -> {
            int status = Low.gphys_solver_create(desc == null ? null : desc.pointer(), made);
            Low.keep(desc);
            return status;
        });
    }

    /**
     * Change the number of threads that share the steps of a solver, as Scene.setWorkerCount. The bits of
     * the motion stay the same.
     * Cost: as Scene.setWorkerCount; allocates. Since 1.1.
     * @param workers as SolverDesc.worker_count
     * @throws GamephysException with ERROR_OUT_OF_MEMORY: also if the threads cannot be started; the
     *     former ones are kept
     */
    public void setWorkerCount(int workers) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_worker_count(self, workers);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * How many threads share the steps of a solver, as Scene.getWorkerCount.
     * Cost: O(1). Since 1.1.
     */
    public int getWorkerCount() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_worker_count(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(1);
    }

    /**
     * Move the point of the world that the coordinates of all particles count from; see Scene.setOrigin.
     * Particles stay where they are in the world and keep moving as they do. A step and an attachment need
     * a scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
     * Cost: O(particles).
     * @param origin x, y, z in the world, metres, within MAX_COORDINATE
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: also if a particle or an animation target
     *     would leave the range of coordinates
     */
    public void setOrigin(double[] origin) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_origin(self, scratch.put(1, origin, 3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Where in the world the particles' coordinates count from, metres.
     * Cost: O(1).
     */
    public double[] getOrigin() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_origin(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.doubles(1, 3);
    }

    /**
     * Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
     * Cost: O(bodies).
     * @param gravity m/s^2; may be zero
     */
    public void setGravity(Vec3 gravity) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_gravity(self, scratch.put(1, gravity));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Change the number of substeps of a step. More substeps: smaller errors, proportionally more time.
     * The error of motion goes with the square of their length. Ropes that move calmly - in a substep no
     * link turns by half a radian, or would swing by one if its ends were pushed - make each in two stages
     * (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the error.
     * Cost: O(1).
     * @param substeps 1 .. 1000
     */
    public void setSubsteps(int substeps) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_substeps(self, substeps);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The settings of a solver as they are.
     * Cost: O(1).
     */
    public SolverSettings getSettings() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_settings(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return SolverSettings.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Change all settings, from the next step on. Read them, change some, and give them back. Bodies wake
     * if gravity or the settings of sleep change. Time that Solver.advance owes beyond the new fixed_step
     * is dropped.
     * Cost: O(bodies).
     */
    public void setSettings(SolverSettings settings) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_settings(self, scratch.put(1, settings));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Add a body of particles without constraints.
     * Cost: O(elements).
     * @param desc null: the defaults
     * @param positions metres
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
     */
    public int addParticles(Batch<Vec3> positions, BodyDesc desc) {
        Scratch scratch = Scratch.get();
        int count = Low.common(positions.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_add_particles(self, desc == null ? null : desc.pointer(), positions.pointer(), positions.stride(), count, scratch.slot(5));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, desc, positions);
        Low.check(status);
        return scratch.getInt(5);
    }

    /** The same with defaults. */
    public int addParticles(Batch<Vec3> positions) {
        return addParticles(positions, (BodyDesc) null);
    }

    /**
     * Add a rope through the given points, one particle at each.
     * Cost: O(elements).
     * @param desc null: the defaults
     * @param positions metres
     * @param linkLength rest length of each link in metres; 0: as placed. A length below 1e-9 m counts as
     *     0. Rigid links get their lengths in the first step, and the particles no speed by it.
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
     */
    public int addRope(Batch<Vec3> positions, float linkLength, BodyDesc desc) {
        Scratch scratch = Scratch.get();
        int count = Low.common(positions.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_add_rope(self, desc == null ? null : desc.pointer(), positions.pointer(), positions.stride(), count, linkLength, scratch.slot(6));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, desc, positions);
        Low.check(status);
        return scratch.getInt(6);
    }

    /** The same with defaults. */
    public int addRope(Batch<Vec3> positions, float linkLength) {
        return addRope(positions, linkLength, (BodyDesc) null);
    }

    /** The same with defaults. */
    public int addRope(Batch<Vec3> positions) {
        return addRope(positions, 0, (BodyDesc) null);
    }

    /**
     * Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
     * corner + column / (columns - 1) * edgeU + row / (rows - 1) * edgeV. Its constraints, in the order of
     * their ids, are those from row to row, those from column to column, both diagonals (CLOTH_SHEAR), and
     * those that resist folding (CLOTH_BEND); Solver.setConstraintSettings makes them softer or stiffer
     * later.
     * Cost: O(columns * rows).
     * @param desc null: the defaults
     * @param corner metres
     * @param edgeU metres, from the corner along a row
     * @param edgeV metres, from the corner along a column
     * @param columns &gt;= 2
     * @param rows &gt;= 2
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if the edges are parallel or zero
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 particles, links or bodies
     */
    public int addCloth(Vec3 corner, Vec3 edgeU, Vec3 edgeV, int columns, int rows, BodyDesc desc) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_add_cloth(self, desc == null ? null : desc.pointer(), scratch.put(2, corner), scratch.put(3, edgeU), scratch.put(4, edgeV), columns, rows, scratch.slot(7));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, desc);
        Low.check(status);
        return scratch.getInt(7);
    }

    /** The same with defaults. */
    public int addCloth(Vec3 corner, Vec3 edgeU, Vec3 edgeV, int columns, int rows) {
        return addCloth(corner, edgeU, edgeV, columns, rows, (BodyDesc) null);
    }

    /**
     * Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and with
     * CLOTH_BEND one across each inner edge, whose ids come after those of the edges. Vertices at the same
     * place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported balls, has a rest
     * length of 0.
     * Cost: O(n log n).
     * @param desc null: the defaults
     * @param transform places the mesh; null is the identity
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
     * @throws GamephysException with ERROR_UNSUPPORTED: for a mesh made from a rope or from particles,
     *     which has no triangles
     */
    public int addClothMesh(Mesh mesh, Transform transform, BodyDesc desc) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer mesh_ = Owned.enter(mesh);
            try {
                status = Low.gphys_solver_add_cloth_mesh(self, desc == null ? null : desc.pointer(), mesh_, scratch.put(3, transform), scratch.slot(4));
            } finally {
                Owned.leave(mesh);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, desc, mesh);
        Low.check(status);
        return scratch.getInt(4);
    }

    /** The same with defaults. */
    public int addClothMesh(Mesh mesh, Transform transform) {
        return addClothMesh(mesh, transform, (BodyDesc) null);
    }

    /** The same with defaults. */
    public int addClothMesh(Mesh mesh) {
        return addClothMesh(mesh, (Transform) null, (BodyDesc) null);
    }

    /**
     * Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave in
     * the last step are no longer listed.
     * Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave
     * impulses to the same models).
     */
    public void removeBody(int body) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_remove_body(self, body);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Ids of all bodies, ascending.
     * Cost: O(bodies).
     */
    public Batch<Integer> getBodies() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_bodies(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Ids of the bodies that are asleep, ascending. A body falls asleep at the end of a step when for
     * sleep_time seconds no particle was faster than sleep_speed and no rigid constraint strained by more
     * than sleep_strain; cloth, when its root mean square speed from step to step was no higher, no
     * particle ten times as fast, and strain, without a max_strain, at most 3 %, that of diagonals of
     * cells apart: these yield, on sharp and round models by a tenth and more. Its speed is then 0, it
     * keeps its contacts, and a step costs it one query for models nearby. It wakes in the next step after
     * a model within reach (as far as one could move in a step at 50 m/s) was added, removed or moved, or
     * a model that it is attached to, or after the scene was replaced; and at once by any change of its
     * state, of gravity or of the origin. Cloth is brought to rest, whatever sleep_speed is, once friction
     * holds it on models that stand still and it moves by centimetres a second without sagging further:
     * within a second it is slowed down to 0. It moves again when one of these models or the body changes.
     * Not in wind, with joints, animation targets, clusters or a volume, or near other bodies.
     * Cost: O(bodies).
     */
    public Batch<Integer> getSleeping() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_sleeping(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Wake a body; its time of rest begins again.
     * Cost: O(1) a body.
     * @param body 0: all
     */
    public void wake(int body) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_wake(self, body);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The present settings of a body; static_friction as it acts, at least friction.
     * Cost: O(1).
     */
    public BodySettings getBodySettings(int body) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_body_settings(self, body, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return BodySettings.read(scratch.memory, Scratch.at(2));
    }

    /**
     * Change all settings of a body, from the next step on: read them, change some, and give them back.
     * Wakes the body.
     * Cost: O(1); O(particles) when self_collision changes, and it allocates.
     */
    public void setBodySettings(int body, BodySettings settings) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_body_settings(self, body, scratch.put(2, settings));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * What a body is made of and how it is solved.
     * Cost: O(1); after a change of constraints O(particles), and it allocates.
     */
    public BodyInfo getBodyInfo(int body) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_body_info(self, body, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return BodyInfo.read(scratch.memory, Scratch.at(2));
    }

    /**
     * Particle numbers of a cloth's triangles, three each, for drawing. Where cloth tears (Break) they
     * change, and their number does not.
     * Cost: O(triangles).
     */
    public Batch<Integer> getTriangles(int body) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_triangles(self, body, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * The particle of a body nearest to a point, for example to grab it; of equally near ones the lowest.
     * Cost: O(1); O(particles) for NO_TRIANGLE. Since 1.1.
     * @param triangle as in a hit, nearest or penetration of the body's mesh: its corners are compared, of
     *     a rope the ends of the link, or the particle; NO_TRIANGLE: all particles
     * @param point metres, in the solver's coordinates: that of the hit
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: also if the mesh has no such triangle
     */
    public int getNearestParticle(int body, int triangle, Vec3 point) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_nearest_particle(self, body, triangle, scratch.put(3, point), scratch.slot(4));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(4);
    }

    /**
     * Where the particles are, metres.
     * Cost: O(count).
     * @param first the first particle
     * @param count how many from there on; a range beyond the body is ERROR_INVALID_ARGUMENT
     */
    public Batch<Vec3> getPositions(int body, int first, int count, Batch<Vec3> out) {
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_positions(self, body, first, count, room.pointer(), Vec3.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> getPositions(int body, int first, int count) {
        return getPositions(body, first, count, (Batch<Vec3>) null);
    }

    /**
     * Move particles at once and without collision on the way; velocities stay as they are. Wakes the
     * body. Rigid links that are too long or too short then get their lengths in the next step, and the
     * particles no speed by it. Pinned particles that are moved alone pull the others: during the next
     * step they go evenly from where they were to their new places, as attached ones do. They are placed
     * at once before the body's first step, or if a free particle of the body is placed as well.
     * Cost: O(elements).
     * @param first as in Solver.getPositions
     */
    public void setPositions(int body, int first, Batch<Vec3> positions) {
        int count = Low.common(positions.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_positions(self, body, first, count, positions.pointer(), positions.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, positions);
        Low.check(status);
    }

    /**
     * How fast the particles are, m/s.
     * Cost: O(count).
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     * @return 0 of what is pinned and stands still.
     */
    public Batch<Vec3> getVelocities(int body, int first, int count, Batch<Vec3> out) {
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_velocities(self, body, first, count, room.pointer(), Vec3.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> getVelocities(int body, int first, int count) {
        return getVelocities(body, first, count, (Batch<Vec3>) null);
    }

    /**
     * Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles keep 0.
     * Cost: O(elements).
     * @param first as in Solver.getPositions
     * @param velocities m/s
     */
    public void setVelocities(int body, int first, Batch<Vec3> velocities) {
        int count = Low.common(velocities.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_velocities(self, body, first, count, velocities.pointer(), velocities.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, velocities);
        Low.check(status);
    }

    /**
     * Masses of particles, kg. That of a pinned particle is what it has when it is released.
     * Cost: O(count).
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     */
    public Batch<Float> getMasses(int body, int first, int count, Batch<Float> out) {
        Batch<Float> room = Batch.room(Layout.FLOAT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_masses(self, body, first, count, room.pointer(), Layout.FLOAT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Float> getMasses(int body, int first, int count) {
        return getMasses(body, first, count, (Batch<Float>) null);
    }

    /**
     * Change the masses of particles. A pinned particle keeps its mass for the time when it is released.
     * Wakes the body.
     * Cost: O(elements).
     * @param first as in Solver.getPositions
     * @param masses kg, &gt; 0
     */
    public void setMasses(int body, int first, Batch<Float> masses) {
        int count = Low.common(masses.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_masses(self, body, first, count, masses.pointer(), masses.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, masses);
        Low.check(status);
    }

    /**
     * Collision radii of particles, metres.
     * Cost: O(count).
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     */
    public Batch<Float> getRadii(int body, int first, int count, Batch<Float> out) {
        Batch<Float> room = Batch.room(Layout.FLOAT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_radii(self, body, first, count, room.pointer(), Layout.FLOAT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Float> getRadii(int body, int first, int count) {
        return getRadii(body, first, count, (Batch<Float>) null);
    }

    /**
     * Change the collision radii of particles. Wakes the body.
     * Cost: O(elements).
     * @param first as in Solver.getPositions
     * @param radii metres, &gt;= 0
     */
    public void setRadii(int body, int first, Batch<Float> radii) {
        int count = Low.common(radii.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_radii(self, body, first, count, radii.pointer(), radii.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, radii);
        Low.check(status);
    }

    /**
     * Friction factors of particles; 1 until they are set.
     * Cost: O(count). Since 1.1.
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     */
    public Batch<Float> getFrictionFactors(int body, int first, int count, Batch<Float> out) {
        Batch<Float> room = Batch.room(Layout.FLOAT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_friction_factors(self, body, first, count, room.pointer(), Layout.FLOAT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Float> getFrictionFactors(int body, int first, int count) {
        return getFrictionFactors(body, first, count, (Batch<Float>) null);
    }

    /**
     * Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In every
     * contact, with models and with particles, the coefficients of a particle are the friction and the
     * static_friction of its body times its factor. A body with a friction of 1 thus has the factors for
     * coefficients; Solver.setBodySettings scales them all and keeps the factors. Wakes the body.
     * Cost: O(elements); the first factor other than 1 O(particles), and it allocates. Since 1.1.
     * @param first as in Solver.getPositions
     * @param factors &gt;= 0
     */
    public void setFrictionFactors(int body, int first, Batch<Float> factors) {
        int count = Low.common(factors.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_friction_factors(self, body, first, count, factors.pointer(), factors.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, factors);
        Low.check(status);
    }

    /**
     * The forces that were set for particles, newtons.
     * Cost: O(count).
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     */
    public Batch<Vec3> getForces(int body, int first, int count, Batch<Vec3> out) {
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_forces(self, body, first, count, room.pointer(), Vec3.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> getForces(int body, int first, int count) {
        return getForces(body, first, count, (Batch<Vec3>) null);
    }

    /**
     * Set the forces that act on particles beside gravity, from now on until set again. Wakes the body.
     * Cost: O(elements).
     * @param first as in Solver.getPositions
     * @param forces newtons
     */
    public void setForces(int body, int first, Batch<Vec3> forces) {
        int count = Low.common(forces.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_forces(self, body, first, count, forces.pointer(), forces.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, forces);
        Low.check(status);
    }

    /**
     * Which particles are pinned or attached.
     * Cost: O(count).
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     */
    public Batch<Integer> getPinned(int body, int first, int count, Batch<Integer> out) {
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_pinned(self, body, first, count, room.pointer(), Layout.INT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Integer> getPinned(int body, int first, int count) {
        return getPinned(body, first, count, (Batch<Integer>) null);
    }

    /**
     * Pin or release particles. A pinned particle stays where it is put and moves only by
     * Solver.setPositions, or with an animation target of maxDistance 0; else its speed is 0. Both pinning
     * and releasing end an attachment.
     * Cost: O(count).
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     * @param pinned true: pin; false: release
     */
    public void setPinned(int body, int first, int count, boolean pinned) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_pinned(self, body, first, count, pinned ? 1 : 0);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Put a body into moving air. Until this is called there is none. Wakes the body. With u the velocity
     * relative to the air, the force is on a triangle of cloth -rho/2 A |u| ((C_D cos a - C_L cos^2 a) u +
     * C_L (u . n) n), cos a = |u . n| / |u|, the first term not below 0: drag as A cos a, which is what
     * the wind sees of it, and lift across the wind as sin a cos a (Keckeisen et al. 2004, "Modelling
     * effects of wind fields in cloth animations"); with C_L = C_D it is nearly the pressure on a plate,
     * along n; on a link of a rope -rho/2 C_D 2 r l |u'| u', u' the part of u across it, r the radius (the
     * cross-flow principle: Hoerner 1965, "Fluid-dynamic drag"); on a free particle -rho/2 C_D pi r^2 |u|
     * u. Strong wind carries bodies along but never overshoots: whatever the density, a substep does not
     * reverse u. The drag of a free particle is of second order in the substep; that of a link is the one
     * at the beginning of the step.
     * Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a rope
     * as many for each link; some 100 for each free particle, as often as drag takes 1/32 of a speed.
     * @param body 0: all bodies there are
     * @param wind of density 0: no air
     */
    public void setWind(int body, Wind wind) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_wind(self, body, scratch.put(2, wind));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The air around a body as it was set; zeros if it was not.
     * Cost: O(1).
     */
    public Wind getWind(int body) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_wind(self, body, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Wind.read(scratch.memory, Scratch.at(2));
    }

    /**
     * Give the air at particles a velocity beside that of Wind, from now on until set again: gusts,
     * eddies, a field of your own that is sampled at the particles' positions. Wakes the body.
     * Cost: O(elements); the first time O(particles), and it allocates.
     * @param first as in Solver.getPositions
     * @param velocities m/s
     */
    public void setAirVelocities(int body, int first, Batch<Vec3> velocities) {
        int count = Low.common(velocities.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_air_velocities(self, body, first, count, velocities.pointer(), velocities.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, velocities);
        Low.check(status);
    }

    /**
     * Velocities of the air at particles, m/s, beside that of Wind.
     * Cost: O(count).
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     */
    public Batch<Vec3> getAirVelocities(int body, int first, int count, Batch<Vec3> out) {
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_air_velocities(self, body, first, count, room.pointer(), Vec3.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> getAirVelocities(int body, int first, int count) {
        return getAirVelocities(body, first, count, (Batch<Vec3>) null);
    }

    /**
     * Give particles animation targets, before each step that is to follow an animation: a cape or skirt
     * that is skinned to its character stays within maxDistance of the skinned vertices and does not sink
     * into the body behind them. In the next step position and normal go evenly from the old target to the
     * new one, substep by substep; distances act at once. A target that is not set again stands still. A
     * first target, and that of a particle which Solver.setPositions has moved since the last step, takes
     * effect at its new place at once: to teleport, make that call and this one. If the body is attached
     * to a model that jumps (Solver.step), this call alone is enough. maxDistance 0 carries a particle: it
     * is at its target, as if attached there, and moves links with infinite mass; this also moves a pinned
     * particle, which stays pinned, at constant speed during a step. Otherwise particles that are pinned
     * or attached are not moved. A particle that is out of its bounds at the end of a substep is put on
     * the nearest place within both, without friction; its velocity across them is then that of the
     * target. What lies within its bounds is not touched. Bounds act after constraints and before models:
     * where a target is inside a model, or behind one, the particle stays outside. Links yield to bounds
     * that contradict them. What hangs from a particle at its bounds is carried, in cloth and in ropes
     * that are moved alone; ropes and free particles that are joined, or collide with bodies, are put back
     * particle by particle, and links beside these may be strained by the motion of a substep. Wakes the
     * body if a target changes.
     * Cost: O(elements); the first time O(particles), and it allocates. In each substep some 100 ns a
     * particle; ropes with targets are solved one by one, as those that touch models. Since 1.1.
     * @param first as in Solver.getPositions
     * @param targets maxDistance and backstop INFINITY: no target any more
     */
    public void setAnimationTargets(int body, int first, Batch<AnimationTarget> targets) {
        int count = Low.common(targets.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_animation_targets(self, body, first, count, targets.pointer(), targets.stride());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, targets);
        Low.check(status);
    }

    /**
     * Animation targets of particles as they were set; 0 and INFINITY of what has none.
     * Cost: O(count). Since 1.1.
     * @param first as in Solver.getPositions
     * @param count as in Solver.getPositions
     */
    public Batch<AnimationTarget> getAnimationTargets(int body, int first, int count, Batch<AnimationTarget> out) {
        Batch<AnimationTarget> room = Batch.room(AnimationTarget.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_animation_targets(self, body, first, count, room.pointer(), AnimationTarget.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<AnimationTarget> getAnimationTargets(int body, int first, int count) {
        return getAnimationTargets(body, first, count, (Batch<AnimationTarget>) null);
    }

    /**
     * Fix a particle to a model: it follows the model's transform in each step, and is released when the
     * model is gone. Steps must then be given this scene; in a step without one the particle stays where
     * it is. If the model jumps (Solver.step), the whole body goes with it as if it were rigid, and its
     * velocities turn with it: a cape stays on a character that respawns. Bodies with other pinned
     * particles, joints, or attachments to models that go elsewhere do not, nor do bodies without
     * constraints.
     * Cost: O(1); allocates.
     * @param scene of the same origin as the solver; not modified
     * @param localPoint in the model's coordinates, to which its transform applies, with the transform's
     *     scale, and not Scene.setScale; null: where the particle is now
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for a particle that does not exist
     */
    public void attach(Scene scene, int body, int particle, int model, Vec3 localPoint) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_solver_attach(self, scene_, body, particle, model, scratch.put(5, localPoint));
            } finally {
                Owned.leave(scene);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, scene);
        Low.check(status);
    }

    /** The same with defaults. */
    public void attach(Scene scene, int body, int particle, int model) {
        attach(scene, body, particle, model, (Vec3) null);
    }

    /**
     * Release an attached particle.
     * Cost: O(1).
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if it is not attached, or does not exist
     */
    public void detach(int body, int particle) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_detach(self, body, particle);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The attachments of a body, by particle. One to a model that is gone is listed until the next step.
     * Cost: O(attachments). Since 1.1.
     */
    public Batch<Attachment> getAttachments(int body) {
        return Low.list(Attachment.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_attachments(self, body, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Hold two different particles of a body at a distance.
     * Cost: O(1); the next step plans the body again, O(constraints).
     * @param restLength metres, &gt;= 0; negative: the present distance. Below 1e-9 m it counts as 0.
     * @param compliance metres per newton, &gt;= 0; 0 is rigid
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for a particle that does not exist or twice
     *     the same one
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 constraints of a body
     */
    public int addDistance(int body, int particleA, int particleB, float restLength, float compliance) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_add_distance(self, body, particleA, particleB, restLength, compliance, scratch.slot(6));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(6);
    }

    /** The same with defaults. */
    public int addDistance(int body, int particleA, int particleB, float restLength) {
        return addDistance(body, particleA, particleB, restLength, 0);
    }

    /**
     * Keep two different particles of a body from being further apart than a length, like a string between
     * them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
     * rigid, only the speed at which the particles separate is lost.
     * Fails as Solver.addDistance.
     * It is a constraint like others: listed with maxLength as its restLength, removed as they are, and
     * strained only when it is too long.
     * Cost: as Solver.addDistance.
     * @param maxLength metres, &gt;= 0; negative: the present distance. Below 1e-9 m it counts as 0.
     * @param compliance metres per newton, &gt;= 0, of what it yields beyond that; 0 is rigid
     */
    public int addMaxDistance(int body, int particleA, int particleB, float maxLength, float compliance) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_add_max_distance(self, body, particleA, particleB, maxLength, compliance, scratch.slot(6));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(6);
    }

    /** The same with defaults. */
    public int addMaxDistance(int body, int particleA, int particleB, float maxLength) {
        return addMaxDistance(body, particleA, particleB, maxLength, 0);
    }

    /**
     * Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping * v
     * in addition to its tension; one of Solver.addMaxDistance never pushes. The decay depends on time,
     * not on steps. Rigid constraints have nothing to damp.
     * Cost: as Solver.addDistance.
     * @param damping N s/m, &gt;= 0; 0, which every constraint begins with: none
     * @throws GamephysException with ERROR_INVALID_ID: for a body or constraint that does not exist
     */
    public void setConstraintDamping(int body, int constraint, float damping) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_constraint_damping(self, body, constraint, damping);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body;
     * setting it again changes it, which inflates a body.
     * Cost: O(triangles) in each substep, twice. Allocates.
     * @param restVolume m^3, &gt; 0; negative: the present volume
     * @param compliance m^3 per pascal, &gt;= 0: the volume that a pressure of one pascal takes; 0: as water,
     *     which keeps its volume; INFINITY: none, which ends the constraint
     * @throws GamephysException with ERROR_UNSUPPORTED: if the triangles do not close (each side is that
     *     of two triangles), are not oriented consistently, or face inward when the present volume is
     *     asked for
     */
    public void setVolume(int body, float restVolume, float compliance) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_volume(self, body, restVolume, compliance);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /** The same with defaults. */
    public void setVolume(int body, float restVolume) {
        setVolume(body, restVolume, 0);
    }

    /** What getVolume returns. */
    public record VolumeResult(float volume, float pressure) {}

    /**
     * The volume held by Solver.setVolume, m^3, as it is, and the pressure in pascals with which it was
     * held at the end of the last step: above 0 it pushes outward.
     * Cost: O(triangles).
     * @throws GamephysException with ERROR_UNSUPPORTED: if none is held
     */
    public VolumeResult getVolume(int body) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_volume(self, body, scratch.slot(2), scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new VolumeResult(scratch.getFloat(2), scratch.getFloat(3));
    }

    /** What getVolumeSettings returns. */
    public record VolumeSettingsResult(float restVolume, float compliance) {}

    /**
     * What was given to Solver.setVolume: m^3 (for a negative volume the one at that time), and m^3 per
     * pascal.
     * Cost: O(1). Since 1.1.
     * @throws GamephysException with ERROR_UNSUPPORTED: if none is held
     */
    public VolumeSettingsResult getVolumeSettings(int body) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_volume_settings(self, body, scratch.slot(2), scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new VolumeSettingsResult(scratch.getFloat(2), scratch.getFloat(3));
    }

    /**
     * Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body. The
     * triangles of cloth stay together: Solver.breakConstraint tears them apart.
     * Cost: as Solver.addDistance; allocates.
     * @throws GamephysException with ERROR_INVALID_ID: for a body or constraint that does not exist, or no
     *     longer
     */
    public void removeConstraint(int body, int constraint) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_remove_constraint(self, body, constraint);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * All constraints of a body, including those created with the body, by id.
     * Cost: O(constraints).
     */
    public Batch<ConstraintInfo> getConstraints(int body) {
        return Low.list(ConstraintInfo.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_constraints(self, body, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Which constraints keep a length, and which a maximum.
     * Cost: O(elements). Since 1.1.
     * @param constraints the ids; one may appear twice
     */
    public Batch<Integer> getConstraintKinds(int body, Batch<Integer> constraints, Batch<Integer> out) {
        int count = Low.common(constraints.common());
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_constraint_kinds(self, body, constraints.pointer(), count, room.pointer(), Layout.INT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, constraints, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Integer> getConstraintKinds(int body, Batch<Integer> constraints) {
        return getConstraintKinds(body, constraints, (Batch<Integer>) null);
    }

    /**
     * The present settings of constraints.
     * Cost: O(elements).
     * @param constraints the ids; one may appear twice
     */
    public Batch<ConstraintSettings> getConstraintSettings(int body, Batch<Integer> constraints, Batch<ConstraintSettings> out) {
        int count = Low.common(constraints.common());
        Batch<ConstraintSettings> room = Batch.room(ConstraintSettings.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_constraint_settings(self, body, constraints.pointer(), count, room.pointer(), ConstraintSettings.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, constraints, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<ConstraintSettings> getConstraintSettings(int body, Batch<Integer> constraints) {
        return getConstraintSettings(body, constraints, (Batch<ConstraintSettings>) null);
    }

    /**
     * Change constraints while they act, all or none: winches, muscles. A rest length goes from the old to
     * the new one at constant speed during the next step; a winch that reels in at v m/s is given a length
     * that is v dt shorter before each step of dt. Wakes the body.
     * Cost: O(elements); in the next step O(constraints) to pack them again, of rigid cloth with pins that
     * gets longer links O(n log n). Chains are not planned again. Allocates.
     * @param constraints the ids; one that appears twice gets the last
     */
    public void setConstraintSettings(int body, Batch<Integer> constraints, Batch<ConstraintSettings> settings) {
        int count = Low.common(constraints.common(), settings.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_constraint_settings(self, body, constraints.pointer(), settings.pointer(), settings.stride(), count);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, constraints, settings);
        Low.check(status);
    }

    /**
     * Make particles of a body a rigid cluster: they keep the shape in which they are now, and move and
     * turn as one stiff part, such as a plank of a bridge, a crate or a plate of armour. Links between
     * them are not needed. A particle may be in several clusters: planks with two particles in common are
     * hinged there, with one they are jointed. The mass of a cluster is that of its particles; hollow
     * shapes are light in the middle. Particles that are pinned or attached stay where they are held: with
     * one the cluster swings about it, with two about the line through them, and with three that are not
     * on a line it does not move. Models that particles are attached to get the impulses. Contacts with
     * models move the cluster as a whole, with friction; only particles touch, not the faces between them,
     * so they should be no further apart than the thickness of the thinnest thing that a cluster meets. It
     * bounces as a whole, too; one that is held, joined, or shares particles shows only the share of its
     * restitution that its particles in contact have of its mass. A shape is matched once in each substep,
     * after the links: then what hangs from it by links may be strained a little, and clusters that share
     * particles approach their shapes in eight passes. What is joined to it by Solver.join is solved
     * together with it, unless one of its particles is attached, or another cluster has it, too: hang
     * heavy loads, or a light cluster under a heavy load, by joints. Bodies with clusters are solved as
     * cloth (SOLVE_GRAPH), ropes and free particles too. The rest positions of cloth are not changed by a
     * cluster.
     * Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and 0.3
     * us one that touches a model, and up to eight times that if clusters of the body share particles; the
     * first and the last cluster plan the body again, O(constraints). Since 1.1.
     * @param particles count different particles, at least 2
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for a particle that does not exist or appears
     *     twice
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 clusters of a body, or that many
     *     particles in them
     */
    public int addCluster(int body, Batch<Integer> particles) {
        Scratch scratch = Scratch.get();
        int count = Low.common(particles.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_add_cluster(self, body, particles.pointer(), count, scratch.slot(4));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, particles);
        Low.check(status);
        return scratch.getInt(4);
    }

    /**
     * End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
     * Cost: O(particles in clusters of the body). Since 1.1.
     * @throws GamephysException with ERROR_INVALID_ID: for a body or cluster that does not exist, or no
     *     longer
     */
    public void removeCluster(int body, int cluster) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_remove_cluster(self, body, cluster);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * All clusters of a body, by id.
     * Cost: O(clusters). Since 1.1.
     */
    public Batch<Integer> getClusters(int body) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_clusters(self, body, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * The particles of a cluster, in the order in which they were given.
     * Cost: O(particles of the cluster). Since 1.1.
     * @throws GamephysException with ERROR_INVALID_ID: for a body or cluster that does not exist, or no
     *     longer
     */
    public Batch<Integer> getClusterParticles(int body, int cluster) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_cluster_particles(self, body, cluster, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that
     * are equal and opposite; either may be pinned or attached. Joined ropes, free particles and rigid
     * clusters are solved as one system, as stiff as one rope; a joined particle of cloth has the inertia
     * of all that hangs on it. Free particles of a joined body are moved by the time scheme of ropes, no
     * longer exactly. Joined bodies are moved by one thread and fall asleep and wake together. A joint is
     * removed with either body. Particles of the two that are linked to a joint within touch of each other
     * do not collide there.
     * Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as one
     * of a rope that is not joined. Allocates.
     * @param restLength metres; 0: at the same place, as below 1e-9; negative: the present distance.
     *     Particles at another distance are moved to it in the next step; by a rigid joint without speed.
     * @param compliance metres per newton, &gt;= 0; 0 is rigid
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for a particle that does not exist or twice
     *     the same body (see Solver.addDistance)
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 joints
     */
    public int join(int bodyA, int particleA, int bodyB, int particleB, float restLength, float compliance) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_join(self, bodyA, particleA, bodyB, particleB, restLength, compliance, scratch.slot(7));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(7);
    }

    /** The same with defaults. */
    public int join(int bodyA, int particleA, int bodyB, int particleB, float restLength) {
        return join(bodyA, particleA, bodyB, particleB, restLength, 0);
    }

    /**
     * End a joint. Wakes both bodies.
     * Cost: as Solver.join.
     * @throws GamephysException with ERROR_INVALID_ID: for a joint that does not exist, or no longer
     */
    public void unjoin(int joint) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_unjoin(self, joint);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Joints of a body, by id.
     * Cost: O(joints of the solver).
     * @param body 0: of all bodies
     */
    public Batch<JointInfo> getJoints(int body) {
        return Low.list(JointInfo.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_joints(self, body, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Breaking forces of constraints. Wakes the body.
     * Cost: O(elements + constraints); of cloth that gets its first or loses its last one also that of a
     * pin. Allocates. Since 1.1.
     * @param constraints the ids; one that appears twice gets the last
     * @param forces newtons, &gt;= 0; 0: never breaks, as all that are added to a body later
     */
    public void setBreakingForces(int body, Batch<Integer> constraints, Batch<Float> forces) {
        int count = Low.common(constraints.common(), forces.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_set_breaking_forces(self, body, constraints.pointer(), forces.pointer(), forces.stride(), count);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, constraints, forces);
        Low.check(status);
    }

    /**
     * What Solver.setBreakingForces or BodyDesc.breaking_force has set; 0: never breaks.
     * Cost: O(elements). Since 1.1.
     * @param constraints the ids; one may appear twice
     * @return newtons.
     */
    public Batch<Float> getBreakingForces(int body, Batch<Integer> constraints, Batch<Float> out) {
        int count = Low.common(constraints.common());
        Batch<Float> room = Batch.room(Layout.FLOAT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_breaking_forces(self, body, constraints.pointer(), count, room.pointer(), Layout.FLOAT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, constraints, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Float> getBreakingForces(int body, Batch<Integer> constraints) {
        return getBreakingForces(body, constraints, (Batch<Float>) null);
    }

    /**
     * Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the body.
     * Cost: O(particles + constraints); allocates. Since 1.1.
     * @return what came of it.
     * @throws GamephysException with ERROR_UNSUPPORTED: and nothing has changed, for an edge where the
     *     cloth cannot part: of a triangle that is connected to no other
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 particles or constraints
     */
    public Break breakConstraint(int body, int constraint) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_break_constraint(self, body, constraint, scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Break.read(scratch.memory, Scratch.at(3));
    }

    /**
     * Constraints that broke in the last Solver.step or Solver.advance, in its order: for sounds, dust,
     * and to know that a body has more particles. Not those that the caller broke. They are not part of
     * snapshots: after Solver.restore there are none.
     * Cost: O(breaks); no allocation. The same bits for any number of workers. Since 1.1.
     */
    public Batch<Break> getBreaks() {
        return Low.list(Break.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_breaks(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
     * takes more where they would be longer than 25 ms.
     * Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
     * through particles. A model moves evenly from its place at the last step to its present one, unless
     * it jumps: it turns by a right angle or more, its velocity changes by more than 50 m/s to more than
     * that, or its surface does by a change of scale. One that jumps is not swept and gives no speed. What
     * is then within a solid is pushed out slowly; what is then behind a plane or a mesh stays there.
     * Allocates when what it steps has changed.
     * Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1) and a
     * scene query for a body that the last step, of the same dt, left exactly as it was.
     * @param scene to collide with and to follow attachments; null: none. Not modified.
     * @param dt seconds, 1e-6 .. 0.5
     */
    public void step(Scene scene, float dt) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_solver_step(self, scene_, dt);
            } finally {
                Owned.leave(scene);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, scene);
        Low.check(status);
    }

    /** What advance returns. */
    public record AdvanceResult(int steps, float leftover) {}

    /**
     * Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next frame,
     * so the motion does not depend on the frame rate. Models, pins and animation targets are given the
     * places of the end of the frame. They move there evenly in the time since the last step: attached
     * particles, pins and what lies on models are at their places of the time that the solver has reached,
     * leftover of a step before that of the frame. Impulses, contacts and breaks are those of the last
     * step.
     * Cost: that of the steps made.
     * @param frameTime seconds, &gt;= 0
     * @return steps made. 0 &lt;= fraction of a step still owed &lt; 1, to interpolate when drawing.
     * @throws GamephysException with ERROR_OUT_OF_MEMORY: if there is none for the first step: nothing has
     *     changed. If there is none for a later one
     */
    public AdvanceResult advance(Scene scene, float frameTime) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_solver_advance(self, scene_, frameTime, scratch.slot(3), scratch.slot(4));
            } finally {
                Owned.leave(scene);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, scene);
        Low.check(status);
        return new AdvanceResult(scratch.getInt(3), scratch.getFloat(4));
    }

    /**
     * The fraction of a step that Solver.advance still owes: what it gave last as leftover, unless the
     * solver was restored or given another fixed_step since.
     * Cost: O(1). Since 1.1.
     * @return from 0 to below 1.
     */
    public float getLeftover() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_leftover(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getFloat(1);
    }

    /**
     * The substeps that a body took in the last step; 0 before its first. With SolverDesc.max_strain or
     * tolerance set, each body takes as many as its own motion needs: their length follows from what the
     * last step measured, the largest strain of its rigid constraints and the local error of the time
     * scheme, both proportional to the square of that length. It is at most quartered and grows by at most
     * an eighth from one step to the next, so a sudden impact exceeds a target for a few steps; one of
     * strain only where links of cloth cannot be relaxed below it. A target that cannot be met takes
     * max_substeps, unless the strain of cloth stays above eight times the target. Where positions jump,
     * by contacts, the error is that of the jump. What may meet others takes at least the set number.
     * Cost: O(1).
     */
    public int getSubsteps(int body) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_substeps(self, body, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(2);
    }

    /**
     * Counts, strain and energy of a body at present.
     * Cost: O(particles + constraints).
     * @param body 0: all bodies together
     */
    public SolverStats getStats(int body) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_stats(self, body, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return SolverStats.read(scratch.memory, Scratch.at(2));
    }

    /**
     * Contacts of the last step by body, particle, model.
     * Cost: O(contacts).
     */
    public Batch<Contact> getContacts() {
        return Low.list(Contact.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_contacts(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Contacts between bodies in the last step, of any substep, by bodyA, particleA, bodyB, particleB: for
     * sounds, damage and sparks. Of sleeping bodies those of the step in which they fell asleep. Contacts
     * with a body that was removed are no longer listed. They are not part of snapshots: after
     * Solver.restore there are none until the next step. Contacts within a body (BodyDesc.self_collision)
     * are not listed. where particles have more than 12 contacts on average, not all are known.
     * Cost: O(contacts); no allocation. The same bits for any number of workers. Since 1.1.
     */
    public Batch<BodyContact> getBodyContacts() {
        return Low.list(BodyContact.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_body_contacts(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
     * which they fell asleep. After Solver.advance, times the steps that it made, they are those of the
     * frame. Divided by dt they are mean forces: what lies on a model presses on it with its weight. A
     * particle of cloth that touches several models at once gives its impulse to the one that it touches
     * most. Models have no mass here: the step does as if they went where you put them, whatever the
     * force. So a rope between a held end and a body of yours must be elastic, its stiffness times dt^2
     * well below the mass of the body, which needs some damping; a body of yours much lighter than what
     * hangs from it should be moved in small steps.
     * Cost: O(models touched); no allocation. The same bits for any number of workers.
     */
    public Batch<Impulse> getImpulses() {
        return Low.list(Impulse.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_impulses(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and
     * impulses, time that Solver.advance still owes. The scene, workers and allocator are not in it.
     * Cost: O(particles + constraints), some 50 words for each.
     * @return the snapshot. It is for the same release of the library and machines of the same byte order;
     *     it may be stored, but not changed.
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^32 - 1 words
     */
    public Batch<Integer> getSnapshot() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_solver_get_snapshot(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
     * time of the snapshot. Steps continue with the same bits as they did then, provided that the scene,
     * too, is as it was. On an error the solver is as before. Any words are safe, also from an untrusted
     * source: all that is used as a number or an index is checked first. Forged words are refused, or
     * taken as a state whose numbers are in range.
     * Cost: as Solver.getSnapshot; allocates.
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for words that are no snapshot, damaged, of
     *     another version or byte order
     * @throws GamephysException with ERROR_OUT_OF_MEMORY: if there is no room for it
     */
    public void restore(Batch<Integer> words) {
        int count = Low.common(words.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_restore(self, words.pointer(), count);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, words);
        Low.check(status);
    }

    /**
     * A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
     * different ones differ with near certainty (not against an adversary). Compare it between machines
     * that run the same simulation, to detect when they diverge.
     * Cost: O(particles + constraints).
     */
    public int[] getHash() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_solver_get_hash(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.ints(1, 2);
    }
}
