// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/**
 * <pre>
 * Settings shared by all kinds of bodies.
 * </pre>
 */
public final class BodyDesc {
    private final ByteBuffer memory = Batch.direct(64);

    public BodyDesc() {
        Low.check(Low.gphys_body_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * kg of the whole body, spread evenly; &gt; 0; default 1
     * </pre>
     */
    public BodyDesc mass(float value) {
        memory.putFloat(4, value);
        return this;
    }

    public float mass() {
        return memory.getFloat(4);
    }

    /**
     * <pre>
     * of each particle for collision, metres, &gt;= 0; default 0.01
     * </pre>
     */
    public BodyDesc radius(float value) {
        memory.putFloat(8, value);
        return this;
    }

    public float radius() {
        return memory.getFloat(8);
    }

    /**
     * <pre>
     * rate in 1/s: velocities decay as exp(-damping t); &gt;= 0; default 0
     * </pre>
     */
    public BodyDesc damping(float value) {
        memory.putFloat(12, value);
        return this;
    }

    public float damping() {
        return memory.getFloat(12);
    }

    /**
     * <pre>
     * Coulomb coefficient against models, &gt;= 0; default 0.5
     * </pre>
     */
    public BodyDesc friction(float value) {
        memory.putFloat(16, value);
        return this;
    }

    public float friction() {
        return memory.getFloat(16);
    }

    /**
     * <pre>
     * speed kept in a bounce, 0 .. 1; default 0
     * </pre>
     */
    public BodyDesc restitution(float value) {
        memory.putFloat(20, value);
        return this;
    }

    public float restitution() {
        return memory.getFloat(20);
    }

    /**
     * <pre>
     * of stretch, metres per newton, &gt;= 0; 0 is inextensible; default 0
     * </pre>
     */
    public BodyDesc compliance(float value) {
        memory.putFloat(24, value);
        return this;
    }

    public float compliance() {
        return memory.getFloat(24);
    }

    /**
     * <pre>
     * of CLOTH_BEND constraints, m/N; default 0.001
     * </pre>
     */
    public BodyDesc bendCompliance(float value) {
        memory.putFloat(28, value);
        return this;
    }

    public float bendCompliance() {
        return memory.getFloat(28);
    }

    /**
     * <pre>
     * cloth values; default SHEAR | BEND
     * </pre>
     */
    public BodyDesc clothFlags(int value) {
        memory.putInt(32, value);
        return this;
    }

    public int clothFlags() {
        return memory.getInt(32);
    }

    /**
     * <pre>
     * mask of the models it collides with; 0: none; default all
     * </pre>
     */
    public BodyDesc layers(int value) {
        memory.putInt(36, value);
        return this;
    }

    public int layers() {
        return memory.getInt(36);
    }

    /**
     * <pre>
     * of particles at rest on a model, slower than after a fall of 4e-4 radii; at least
     * friction, or 0: as friction; default 0
     * </pre>
     */
    public BodyDesc staticFriction(float value) {
        memory.putFloat(40, value);
        return this;
    }

    public float staticFriction() {
        return memory.getFloat(40);
    }

    /**
     * <pre>
     * 1: its particles collide with one another, see below; default 0
     * </pre>
     */
    public BodyDesc selfCollision(int value) {
        memory.putInt(44, value);
        return this;
    }

    public int selfCollision() {
        return memory.getInt(44);
    }

    /**
     * <pre>
     * two bodies collide with each other if their masks share a bit; 0: with none; default 0
     * </pre>
     */
    public BodyDesc bodyLayers(int value) {
        memory.putInt(48, value);
        return this;
    }

    public int bodyLayers() {
        return memory.getInt(48);
    }

    /**
     * <pre>
     * of CLOTH_SHEAR constraints of a grid, m/N, &gt;= 0; 0: as compliance; default 0
     * </pre>
     */
    public BodyDesc shearCompliance(float value) {
        memory.putFloat(52, value);
        return this;
    }

    public float shearCompliance() {
        return memory.getFloat(52);
    }

    /**
     * <pre>
     * of each constraint, newtons, &gt;= 0; 0: none breaks; default 0; see Break
     * </pre>
     */
    public BodyDesc breakingForce(float value) {
        memory.putFloat(56, value);
        return this;
    }

    public float breakingForce() {
        return memory.getFloat(56);
    }

    /**
     * <pre>
     * of ropes, E I in N m^2, &gt;= 0; 0: they bend freely; default 0; see below
     * </pre>
     */
    public BodyDesc bendingStiffness(float value) {
        memory.putFloat(60, value);
        return this;
    }

    public float bendingStiffness() {
        return memory.getFloat(60);
    }
}
