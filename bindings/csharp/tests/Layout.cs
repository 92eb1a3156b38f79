// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
using System;
using Gamephys;

// Size and offsets of each struct as C has them, on 64-bit machines.
static class Layout {
    public static readonly (Type Type, int Size, string[] Names, int[] Offsets)[] Structs = {
        (typeof(Allocator), 24, new string[] { "Allocate", "Release", "User" }, new int[] { 0, 8, 16 }),
        (typeof(TaskRunner), 16, new string[] { "Run", "User" }, new int[] { 0, 8 }),
        (typeof(Vec3), 12, new string[] { "X", "Y", "Z" }, new int[] { 0, 4, 8 }),
        (typeof(Quat), 16, new string[] { "X", "Y", "Z", "W" }, new int[] { 0, 4, 8, 12 }),
        (typeof(Mat4), 64, new string[] {  }, new int[] {  }),
        (typeof(Transform), 32, new string[] { "Position", "Rotation", "Scale" }, new int[] { 0, 12, 28 }),
        (typeof(Ray), 28, new string[] { "Origin", "Direction", "TMax" }, new int[] { 0, 12, 24 }),
        (typeof(Segment), 24, new string[] { "A", "B" }, new int[] { 0, 12 }),
        (typeof(Sphere), 16, new string[] { "Center", "Radius" }, new int[] { 0, 12 }),
        (typeof(Capsule), 28, new string[] { "A", "B", "Radius" }, new int[] { 0, 12, 24 }),
        (typeof(Aabb), 24, new string[] { "Min", "Max" }, new int[] { 0, 12 }),
        (typeof(Obb), 40, new string[] { "Center", "HalfExtents", "Rotation" }, new int[] { 0, 12, 24 }),
        (typeof(Plane), 16, new string[] { "Normal", "Distance" }, new int[] { 0, 12 }),
        (typeof(Triangle), 36, new string[] { "A", "B", "C" }, new int[] { 0, 12, 24 }),
        (typeof(Frustum), 108, new string[] { "Origin" }, new int[] { 0 }),
        (typeof(Hit), 52, new string[] { "Model", "Tag", "T", "Point", "Normal", "Triangle", "U", "V", "Flags" }, new int[] { 0, 4, 8, 12, 24, 36, 40, 44, 48 }),
        (typeof(Nearest), 28, new string[] { "Model", "Tag", "Point", "Distance", "Triangle" }, new int[] { 0, 4, 8, 20, 24 }),
        (typeof(Penetration), 40, new string[] { "Model", "Tag", "Point", "Normal", "Depth", "Triangle" }, new int[] { 0, 4, 8, 20, 32, 36 }),
        (typeof(MeshReport), 32, new string[] { "TriangleCount", "DegenerateCount", "FirstDegenerate", "OutOfRangeCount", "FirstOutOfRange", "BadVertexCount", "FirstBadVertex", "OpenEdgeCount" }, new int[] { 0, 4, 8, 12, 16, 20, 24, 28 }),
        (typeof(MeshDesc), 24, new string[] { "StructSize", "Allocator", "Deformable", "Reserved" }, new int[] { 0, 8, 16, 20 }),
        (typeof(OctreeStats), 32, new string[] { "ItemCount", "UnboundedCount", "NodeCount", "LeafCount", "Depth", "Rebuilds", "Cost", "MemoryBytes" }, new int[] { 0, 4, 8, 12, 16, 20, 24, 28 }),
        (typeof(OctreeBox), 32, new string[] { "Bounds", "Depth", "ItemCount" }, new int[] { 0, 24, 28 }),
        (typeof(SceneDesc), 40, new string[] { "StructSize", "Allocator", "ReserveModels", "TaskRunner", "WorkerCount", "Reserved" }, new int[] { 0, 8, 16, 24, 32, 36 }),
        (typeof(ModelDesc), 16, new string[] { "StructSize", "Parent", "Layers", "Tag" }, new int[] { 0, 4, 8, 12 }),
        (typeof(ModelInfo), 20, new string[] { "Type", "Parent", "Layers", "Tag", "ChildCount" }, new int[] { 0, 4, 8, 12, 16 }),
        (typeof(QueryFilterDesc), 32, new string[] { "StructSize", "Layers", "IgnoredModel", "Flags", "IgnoredModels", "IgnoredCount", "Reserved" }, new int[] { 0, 4, 8, 12, 16, 24, 28 }),
        (typeof(CameraDesc), 40, new string[] { "StructSize", "Allocator", "Handedness", "DepthRange", "ReverseZ", "ViewportWidth", "ViewportHeight", "Reserved" }, new int[] { 0, 8, 16, 20, 24, 28, 32, 36 }),
        (typeof(Orbit), 60, new string[] { "Target", "Up", "Distance", "Yaw", "Pitch", "RadiansPerUnit", "MetresPerUnit", "MinDistance", "MaxDistance", "MinPitch", "MaxPitch" }, new int[] { 0, 12, 24, 28, 32, 36, 40, 44, 48, 52, 56 }),
        (typeof(OrbitSpeeds), 20, new string[] { "RotateX", "RotateY", "Zoom", "PanX", "PanY" }, new int[] { 0, 4, 8, 12, 16 }),
        (typeof(SolverDesc), 80, new string[] { "StructSize", "Allocator", "Gravity", "Substeps", "FixedStep", "MaxSteps", "TaskRunner", "WorkerCount", "SleepSpeed", "SleepStrain", "SleepTime", "MaxStrain", "Tolerance", "MaxSubsteps", "Reserved" }, new int[] { 0, 8, 16, 28, 32, 36, 40, 48, 52, 56, 60, 64, 68, 72, 76 }),
        (typeof(BodyDesc), 52, new string[] { "StructSize", "Mass", "Radius", "Damping", "Friction", "Restitution", "Compliance", "BendCompliance", "ClothFlags", "Layers", "StaticFriction", "SelfCollision", "BodyLayers" }, new int[] { 0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48 }),
        (typeof(BodyInfo), 20, new string[] { "Kind", "Method", "ParticleCount", "ConstraintCount", "TriangleCount" }, new int[] { 0, 4, 8, 12, 16 }),
        (typeof(ConstraintInfo), 20, new string[] { "Id", "ParticleA", "ParticleB", "RestLength", "Compliance" }, new int[] { 0, 4, 8, 12, 16 }),
        (typeof(JointInfo), 32, new string[] { "Id", "BodyA", "ParticleA", "BodyB", "ParticleB", "RestLength", "Compliance", "Force" }, new int[] { 0, 4, 8, 12, 16, 20, 24, 28 }),
        (typeof(SolverStats), 32, new string[] { "ParticleCount", "PinnedCount", "ConstraintCount", "ContactCount", "StrainMax", "StrainRms", "KineticEnergy", "PotentialEnergy" }, new int[] { 0, 4, 8, 12, 16, 20, 24, 28 }),
        (typeof(Contact), 40, new string[] { "Body", "Particle", "Model", "Tag", "Point", "Normal" }, new int[] { 0, 4, 8, 12, 16, 28 }),
        (typeof(Impulse), 32, new string[] { "Model", "Tag", "Linear", "Angular" }, new int[] { 0, 4, 8, 20 }),
    };
}
