using MeshLab.Editing;
using MeshLab.Neighborhoods;
using MeshLab.Numerics;
using MeshLab.Structure;
using MeshLab.Topology;

namespace MeshLab.Benchmarks.Peers;

/// <summary>The classic set of Sieger and Botsch through the public handles and operations, and walks over components and boundaries.</summary>
internal static class StructureOps
{
    [PeerOp("circulator")]
    public static void Circulator(PeerRun run)
    {
        long incidences = 0;
        run.MeasureRounds(
            run.Model.NewMesh,
            mesh =>
            {
                long counter = 0;
                foreach (Vertex v in mesh.Vertices)
                {
                    foreach (Face f in v.Faces)
                        counter += 1 + (f.Index & 0);
                }
                foreach (Face f in mesh.Faces)
                {
                    foreach (Vertex v in f.Vertices)
                        counter += 1 + (v.Index & 0);
                }
                incidences = counter;
            },
            (_, result) => result.Add("incidences", incidences));
    }

    [PeerOp("barycenter")]
    public static void Barycenter(PeerRun run) => run.MeasureRounds(
        run.Model.NewMesh,
        mesh =>
        {
            Vector3D sum = default;
            foreach (Vertex v in mesh.Vertices)
                sum += v.Position;
            Vector3D center = sum / mesh.Vertices.Count;
            foreach (Vertex v in mesh.Vertices)
                v.Position -= center;
        },
        (mesh, result) => result.Measure(mesh));

    // Reading one mesh from several threads is safe, and the same handles serve: these two passes run in blocks, as the library's own do.
    [PeerOp("normals")]
    public static void Normals(PeerRun run) => run.MeasureRounds(
        () => (Mesh: run.Model.NewMesh(), Faces: new Vector3D[run.Model.FaceCount], Vertices: new Vector3D[run.Model.Positions.Length]),
        state =>
        {
            (Mesh mesh, Vector3D[] faceNormals, Vector3D[] vertexNormals) = state;
            Parallelism.ForBlocks(mesh.FaceSlots, (from, to) => FaceNormals(mesh, faceNormals, from, to));
            Parallelism.ForBlocks(mesh.VertexSlots, (from, to) => VertexNormals(mesh, faceNormals, vertexNormals, from, to));
        },
        (state, result) => result.Add("abs_normal_sum", state.Vertices.Sum(n => Math.Abs(n.X) + Math.Abs(n.Y) + Math.Abs(n.Z))).Add("threads", Parallelism.Threads));

    [PeerOp("smoothing")]
    public static void Smoothing(PeerRun run) => run.Measure(
        () => (Mesh: run.Model.NewMesh(), Next: Written(run.Model.Positions.Length)),
        state =>
        {
            (Mesh mesh, Vector3D[] smoothed) = state;
            Parallelism.ForBlocks(mesh.VertexSlots, (from, to) => Smooth(mesh, smoothed, from, to));
            smoothed.CopyTo(mesh.Positions);
            return mesh;
        },
        (_, mesh, result) => result.Measure(mesh).Add("threads", Parallelism.Threads));

    [PeerOp("subdivision-sqrt3")]
    public static void SubdivisionSqrt3(PeerRun run) => run.Measure(
        () => (Mesh: run.Model.NewMesh(), Next: Written(run.Model.Positions.Length)),
        state =>
        {
            (Mesh mesh, Vector3D[] relaxed) = state;
            int vertices = mesh.VertexSlots, edges = mesh.EdgeSlots, faces = mesh.FaceSlots;
            mesh.Reserve(faces, 3 * faces, 2 * faces);
            for (int i = 0; i < vertices; i++)
                relaxed[i] = Relaxed(mesh.Vertices[i]);
            for (int i = 0; i < faces; i++)
                mesh.Faces[i].Split();
            relaxed.CopyTo(mesh.Positions);
            for (int i = 0; i < edges; i++)
                mesh.Edges[i].TryFlip(out _);
            return mesh;
        },
        (_, mesh, result) => result.Measure(mesh));

    [PeerOp("collapse")]
    public static void Collapse(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh =>
        {
            int vertices = mesh.VertexSlots, faces = mesh.FaceSlots;
            for (int i = 0; i < faces; i++)
                mesh.Faces[i].Split();
            for (int i = vertices; i < vertices + faces; i++)
            {
                HalfEdge h = mesh.Vertices[i].Outgoing;
                h.TryCollapse(h.Target.Position, out _);
            }
            mesh.Compact();
            return mesh;
        },
        (_, mesh, result) => result.Measure(mesh));

    [PeerOp("components")]
    public static void Components(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => mesh.FindComponents(),
        (_, components, result) => result.Add("components", components.Count));

    [PeerOp("boundary-loops")]
    public static void BoundaryLoops(PeerRun run) => run.Measure(
        run.Model.NewMesh,
        mesh => mesh.FindBoundaryLoops(),
        (_, loops, result) => result.Add("loops", loops.Count).Add("border_edges", loops.Sum(loop => loop.Count)));

    [PeerOp("memory")]
    public static void Memory(PeerRun run)
    {
        long before = Settled();
        ResetPeak();
        long base_ = Environment.WorkingSet, start = System.Diagnostics.Stopwatch.GetTimestamp();
        Mesh mesh = run.Model.NewMesh();
        double milliseconds = System.Diagnostics.Stopwatch.GetElapsedTime(start).TotalMilliseconds;
        long peak = Peak(), now = Environment.WorkingSet, kept = Settled() - before;
        double faces = run.Model.FaceCount;
        var result = new PeerResult();
        result.Add("peak_bytes", peak - base_).Add("rss_bytes", now - base_).Add("kept_bytes", kept)
            .Add("peak_bytes_per_face", (peak - base_) / faces).Add("kept_bytes_per_face", kept / faces)
            .Add("alive", mesh.Faces.Count > 0 ? 1 : 0);
        run.Emit([milliseconds], result, 1);
    }

    private static void FaceNormals(Mesh mesh, Vector3D[] faceNormals, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            HalfEdge h = mesh.Faces[i].HalfEdge;
            Vector3D p = h.Source.Position;
            faceNormals[i] = Vector3D.Cross(h.Target.Position - p, h.Next.Target.Position - p);
        }
    }

    private static void VertexNormals(Mesh mesh, Vector3D[] faceNormals, Vector3D[] vertexNormals, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            Vector3D sum = default;
            foreach (Face f in mesh.Vertices[i].Faces)
                sum += faceNormals[f.Index];
            double length = sum.Length;
            vertexNormals[i] = length > 0 ? sum / length : sum;
        }
    }

    private static void Smooth(Mesh mesh, Vector3D[] smoothed, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            Vertex v = mesh.Vertices[i];
            if (v.IsBoundary)
            {
                smoothed[i] = v.Position;
                continue;
            }
            Vector3D sum = default;
            int count = 0;
            foreach (Vertex w in v.Neighbors)
            {
                sum += w.Position;
                count++;
            }
            smoothed[i] = sum / count;
        }
    }

    /// <summary>An array whose memory the system has given already, as a peer's property array is when the operation starts.</summary>
    private static Vector3D[] Written(int length)
    {
        var array = new Vector3D[length];
        Array.Fill(array, Vector3D.UnitX);
        return array;
    }

    private static Vector3D Relaxed(Vertex v)
    {
        if (v.IsBoundary)
            return v.Position;
        Vector3D sum = default;
        int n = 0;
        foreach (Vertex w in v.Neighbors)
        {
            sum += w.Position;
            n++;
        }
        double a = (4 - 2 * Math.Cos(2 * Math.PI / n)) / 9;
        return v.Position * (1 - a) + sum * (a / n);
    }

    /// <summary>The managed bytes that are still referred to.</summary>
    private static long Settled()
    {
        GC.Collect(2, GCCollectionMode.Aggressive, blocking: true, compacting: true);
        GC.WaitForPendingFinalizers();
        return GC.GetTotalMemory(forceFullCollection: true);
    }

    private static void ResetPeak()
    {
        if (OperatingSystem.IsLinux() && File.Exists("/proc/self/clear_refs"))
            File.WriteAllText("/proc/self/clear_refs", "5");
    }

    private static long Peak()
    {
        using var process = System.Diagnostics.Process.GetCurrentProcess();
        return process.PeakWorkingSet64;
    }
}
