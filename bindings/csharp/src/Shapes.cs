// Shapes of any kind, and what the structs have beside their fields.
using System;
using System.Runtime.InteropServices;

namespace Gamephys {

/// <summary>A shape of any kind: made from a struct or a Mesh without saying so.</summary>
public partial struct Shape {
    public ShapeType Type { get; internal set; }
    internal AnyShape Data;
    internal Mesh Mesh;

    public static implicit operator Shape(Mesh mesh) {
        if (mesh == null) throw new ArgumentNullException(nameof(mesh));
        return new Shape { Type = ShapeType.Mesh, Mesh = mesh };
    }
}

/// <summary>An array or span of shapes of one kind, or one shape that stands for each of them.</summary>
public readonly ref partial struct Shapes {
    internal readonly ShapeType Type;
    internal readonly ReadOnlySpan<byte> Bytes;
    internal readonly int Count;
    internal readonly Shape One;
    internal readonly bool IsOne;

    private Shapes(ShapeType type, ReadOnlySpan<byte> bytes, int count) {
        Type = type;
        Bytes = bytes;
        Count = count;
        One = default(Shape);
        IsOne = false;
    }
    private Shapes(Shape one) {
        Type = one.Type;
        Bytes = default(ReadOnlySpan<byte>);
        Count = 1;
        One = one;
        IsOne = true;
    }

    public static implicit operator Shapes(Shape one) { return new Shapes(one); }
    public static implicit operator Shapes(Mesh one) { return new Shapes(one); }

    // One element stands for all.
    internal uint Stride { get { return Count <= 1 ? 0 : (uint)(Bytes.Length / Count); } }
}

public sealed partial class Mesh {
    internal unsafe void* Pointer {
        get { return Handle.IsClosed ? throw new ObjectDisposedException(nameof(Mesh)) : (void*)Handle.DangerousGetHandle(); }
    }
}

/// <summary>A place on the screen, in pixels.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Vec2 {
    public float X, Y;
    public Vec2(float x, float y) { X = x; Y = y; }
    public static implicit operator Vec2((float x, float y) v) { return new Vec2(v.x, v.y); }
}

public partial struct Vec3 {
    public static implicit operator Vec3((float x, float y, float z) v) { return new Vec3(v.x, v.y, v.z); }
    public override string ToString() { return $"({X}, {Y}, {Z})"; }
}

public partial struct Quat {
    /// <summary>No rotation.</summary>
    public static readonly Quat Identity = new Quat(0, 0, 0, 1);
}

public partial struct Mat4 {
    public static Mat4 Identity {
        get {
            var m = new Mat4();
            m[0] = m[5] = m[10] = m[15] = 1;
            return m;
        }
    }
}

public partial struct Transform {
    public static readonly Transform Identity = new Transform((0, 0, 0), Quat.Identity, 1);
    public static Transform At(Vec3 position) { return new Transform(position, Quat.Identity, 1); }
}

public partial struct Orbit {
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe Orbit Default {
        get {
            Orbit orbit;
            Support.Check(Low.gphys_orbit_init(&orbit));
            return orbit;
        }
    }
}

public static partial class Geometry {
    /// <summary>Move a shape; each float of the result is within 1 ulp of its largest coordinate. An Aabb becomes an Obb.</summary>
    public static unsafe Shape Transform(Shape shape, Transform transform) {
        var type = shape.Type == ShapeType.Aabb ? ShapeType.Obb : shape.Type;
        void* given = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var moved = new Shape { Type = type };
        Support.Check(Low.gphys_shape_transform(shape.Type, given, &transform, &moved.Data));
        GC.KeepAlive(shape.Mesh);
        return moved;
    }
}

public sealed partial class Scene {
    /// <summary>Whether the id names a model of this scene.</summary>
    public bool Has(uint model) { return Low.gphys_scene_has(Handle, model) == Status.Ok; }

    /// <summary>A model's shape in its own coordinates; not that of a mesh, which new Mesh(scene, model) gives.</summary>
    public unsafe Shape GetShape(uint model) {
        var shape = new Shape { Type = GetInfo(model).Type };
        Support.Check(Low.gphys_scene_get_shape(Handle, model, &shape.Data, (uint)sizeof(AnyShape)));
        return shape;
    }
}

}
