// SPDX-License-Identifier: MIT
//
// A sample for copying: calls libbankshot from C# (docs/c.md). JSON in, JSON out.
using System;
using System.Runtime.InteropServices;
using System.Text;

public static class Bankshot
{
    [StructLayout(LayoutKind.Sequential)]
    private struct NativeText { public IntPtr Data; public UIntPtr Length; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Launch { public double Speed, Angle, Top, Side, Masse; }

    [StructLayout(LayoutKind.Sequential)]
    public struct End
    {
        public double Time, Length, X, Y, Vx, Vy, Wx, Wy, Wz;
        public int Cushions, Kind, Pocket, Reserved;
    }

    [DllImport("bankshot")] private static extern int bankshot_solve(byte[] puzzle, UIntPtr length, string flags, out NativeText answer);
    [DllImport("bankshot")] private static extern int bankshot_simulate(byte[] shot, UIntPtr length, string flags, out NativeText path);
    [DllImport("bankshot")] private static extern void bankshot_free(IntPtr data);
    [DllImport("bankshot")] private static extern IntPtr bankshot_scene_new(byte[] shot, UIntPtr length, out NativeText error);
    [DllImport("bankshot")] private static extern void bankshot_scene_free(IntPtr scene);
    [DllImport("bankshot")] private static extern int bankshot_simulate_many(IntPtr scene, Launch[] launches, UIntPtr count, [Out] End[] ends, int threads);

    /// Returns the answer as `bankshot solve --json` prints it; flags as in "all&path". Throws for an invalid puzzle.
    public static string Solve(string puzzle, string flags = "")
    {
        byte[] text = Encoding.UTF8.GetBytes(puzzle);
        int status = bankshot_solve(text, (UIntPtr)text.Length, flags, out NativeText answer);
        return Take(status, answer);
    }

    /// Returns the path of a shot as `bankshot simulate --json` prints it.
    public static string Simulate(string shot, string flags = "")
    {
        byte[] text = Encoding.UTF8.GetBytes(shot);
        int status = bankshot_simulate(text, (UIntPtr)text.Length, flags, out NativeText path);
        return Take(status, path);
    }

    /// Returns the end of each launch of one scene.
    public static End[] SimulateMany(string shot, Launch[] launches)
    {
        byte[] text = Encoding.UTF8.GetBytes(shot);
        IntPtr scene = bankshot_scene_new(text, (UIntPtr)text.Length, out NativeText error);
        if (scene == IntPtr.Zero) Take(2, error);
        try
        {
            var ends = new End[launches.Length];
            bankshot_simulate_many(scene, launches, (UIntPtr)launches.Length, ends, 0);
            return ends;
        }
        finally { bankshot_scene_free(scene); }
    }

    private static string Take(int status, NativeText native)
    {
        if (native.Data == IntPtr.Zero) throw new OutOfMemoryException();
        var bytes = new byte[(int)native.Length];
        Marshal.Copy(native.Data, bytes, 0, bytes.Length);
        bankshot_free(native.Data);
        string text = Encoding.UTF8.GetString(bytes);
        return status <= 1 ? text : throw new ArgumentException(text);
    }
}
