// What the generated methods stand on: errors, ownership, arrays.
using System;
using System.Runtime.InteropServices;

namespace Gamephys {

/// <summary>A call failed and changed nothing; the message is the library's.</summary>
public class GamephysException : Exception {
    public Status Status { get; }
    internal GamephysException(Status status, string message) : base(message) { Status = status; }
}

/// <summary>The loaded library.</summary>
public static class Library {
    public static Version Version {
        get {
            var number = (int)Low.gphys_version();
            return new Version(number >> 16, number >> 8 & 0xff, number & 0xff);
        }
    }

    /// <summary>The name of a status in C.</summary>
    public static string NameOf(Status status) { return Marshal.PtrToStringAnsi(Low.gphys_status_name(status)); }
}

// Owns one object of the library. Calls keep it alive, and refuse it after Dispose.
internal abstract class ObjectHandle : SafeHandle {
    protected ObjectHandle(IntPtr made) : base(IntPtr.Zero, true) { SetHandle(made); }
    public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
}

internal static class Support {
    // Most lists are shorter; the others take a second call.
    internal const int Guess = 64;

    internal static void Check(Status status) {
        if (status >= 0) return;
        // Each thread has its own message, and this one made the call.
        var message = Marshal.PtrToStringAnsi(Low.gphys_last_error());
        if (status == Status.ErrorOutOfMemory) throw new OutOfMemoryException(message);
        throw new GamephysException(status, message);
    }

    internal static bool Found(Status status) {
        Check(status);
        return status == Status.Ok;
    }

    internal static uint SizeOf<T>(ReadOnlySpan<T> elements) where T : struct { return (uint)Marshal.SizeOf<T>(); }

    // The stride of a batch's input: one element stands for all.
    internal static uint StrideOf<T>(ReadOnlySpan<T> elements) where T : struct {
        return elements.Length == 1 ? 0 : SizeOf(elements);
    }

    // The length of an array that may be left out, which one without elements is not.
    internal static int Optional<T>(ReadOnlySpan<T> elements) where T : struct {
        return elements == default(ReadOnlySpan<T>) ? 1 : elements.Length;
    }

    // The number of elements of a batch, known if an array of just that length is given. In shared
    // arrays one element stands for all.
    internal static uint CommonLength(int known, params int[] shared) {
        foreach (var length in shared) {
            if (length == 1 && (known >= 0 || shared.Length > 1)) continue;
            if (known >= 0 && length != known) throw new ArgumentException($"arrays of different lengths: {length} and {known}");
            known = length;
        }
        return known < 0 ? 1 : (uint)known;
    }

    internal static void RequireLength(int length, ulong wanted) {
        if ((ulong)length != wanted) throw new ArgumentException($"room for {wanted} elements is needed, not for {length}");
    }
}

/// <summary>A list for each element of a batch.</summary>
public sealed class Ragged<T> {
    /// <summary>The lists one behind another.</summary>
    public T[] Values { get; }
    /// <summary>List i is from Offsets[i] to before Offsets[i + 1].</summary>
    public uint[] Offsets { get; }
    internal Ragged(T[] values, uint[] offsets) {
        Values = values;
        Offsets = offsets;
    }
    public ArraySegment<T> this[int i] {
        get { return new ArraySegment<T>(Values, (int)Offsets[i], (int)(Offsets[i + 1] - Offsets[i])); }
    }
}

}
