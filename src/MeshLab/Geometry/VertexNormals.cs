using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Geometry;

/// <summary>How the normals of the faces around a vertex are weighted (§10.4 点法向).</summary>
public enum VertexNormalWeight
{
    /// <summary>§10.4.1 等权: every face alike (Gouraud 1971). Depends on how the surface is cut into triangles.</summary>
    Uniform,

    /// <summary>§10.4.2 面积加权: by area.</summary>
    Area,

    /// <summary>§10.4.3 角度加权: by the angle at the vertex (Thürmer, Wüthrich 1998). Does not change when a face is cut in two through the vertex.</summary>
    Angle,

    /// <summary>§10.4.4 球面内接: by sin θ over the two sides, Σ u × w / (|u|²|w|²) (Max 1999). Exact if the ring lies on a sphere.</summary>
    InscribedSphere,
}

/// <summary>Unit normals of faces and vertices.</summary>
/// <param name="Faces">Per face slot.</param>
/// <param name="Vertices">Per vertex slot.</param>
public sealed record MeshNormals(Vector3D[] Faces, Vector3D[] Vertices);

/// <summary>§10.4 点法向 (vertex normals): the weighted sum of the normals of the faces around a vertex, at length 1.</summary>
/// <remarks>
/// Isolated and deleted vertices, and those whose faces cancel out, get the null vector. Faces of zero area add nothing. The boundary is treated
/// as the faces that are there; the hole adds nothing (in the sum of Max too). O(V + H), in parallel.
/// </remarks>
public static class VertexNormals
{
    extension(Vertex vertex)
    {
        /// <summary>The angle-weighted unit normal; the null vector if there is none. O(valence).</summary>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public Vector3D Normal => vertex.NormalBy(VertexNormalWeight.Angle);

        /// <summary>The unit normal with the given weights; the null vector if there is none. O(valence).</summary>
        /// <param name="weight">How the faces are weighted.</param>
        /// <exception cref="ArgumentException">The vertex is none or deleted.</exception>
        public Vector3D NormalBy(VertexNormalWeight weight)
        {
            vertex.ThrowIfDead();
            Vector3D sum = default;
            foreach (HalfEdge h in vertex.OutgoingHalfEdges)
            {
                if (!h.IsBoundary)
                    sum += CornerNormal(h, weight);
            }
            return Areas.Unit(sum);
        }
    }

    extension(Mesh mesh)
    {
        /// <summary>The unit normal per vertex slot.</summary>
        /// <param name="weight">How the faces are weighted.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such weight.</exception>
        public Vector3D[] ComputeVertexNormals(VertexNormalWeight weight = VertexNormalWeight.Angle)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            if (!mesh.IsTriangleMesh)
                return OfPolygons(mesh, weight);
            return weight switch
            {
                VertexNormalWeight.Uniform => MeansOfFaces(mesh, mesh.ComputeFaceNormals()),
                VertexNormalWeight.Area => OfTriangles<AreaSum>(mesh),
                VertexNormalWeight.Angle => OfTriangles<AngleSum>(mesh),
                VertexNormalWeight.InscribedSphere => OfTriangles<InscribedSphereSum>(mesh),
                _ => throw Unknown(weight),
            };
        }

        /// <summary>The unit normals of faces and vertices together; with equal weights the faces' serve the vertices.</summary>
        /// <param name="weight">How the faces around a vertex are weighted.</param>
        /// <exception cref="ArgumentOutOfRangeException">There is no such weight.</exception>
        public MeshNormals ComputeNormals(VertexNormalWeight weight = VertexNormalWeight.Angle)
        {
            Vector3D[] faces = mesh.ComputeFaceNormals();
            return new(faces, weight == VertexNormalWeight.Uniform ? MeansOfFaces(mesh, faces) : mesh.ComputeVertexNormals(weight));
        }
    }

    private static Vector3D[] MeansOfFaces(Mesh mesh, Vector3D[] faceNormals)
    {
        var normals = new Vector3D[mesh.VertexSlots];
        MeansOfFaces(mesh, faceNormals, normals);
        return normals;
    }

    extension(Mesh mesh)
    {
        /// <summary>Brings equally weighted normals up to date in arrays that are there already: nothing is allocated but the loop itself.</summary>
        /// <param name="faces">One entry per face slot.</param>
        /// <param name="vertices">One entry per vertex slot; those of unused vertices are left alone.</param>
        /// <exception cref="ArgumentException">An array has another length.</exception>
        public void UpdateNormals(Vector3D[] faces, Vector3D[] vertices)
        {
            mesh.ComputeFaceNormals(faces);
            ArgumentNullException.ThrowIfNull(vertices);
            if (vertices.Length != mesh.VertexSlots)
                throw new ArgumentException($"There is room for {vertices.Length} normals; the mesh has {mesh.VertexSlots} vertex slots.", nameof(vertices));
            MeansOfFaces(mesh, faces, vertices);
        }
    }

    /// <summary>The sums of the unit normals of the faces around.</summary>
    private static void MeansOfFaces(Mesh mesh, Vector3D[] faceNormals, Vector3D[] normals)
    {
        Parallelism.ForBlocks(normals.Length, (from, to) => Block(mesh, faceNormals, normals, from, to));

        // Arrays in locals: those of a closure would be read again at every step.
        static void Block(Mesh mesh, Vector3D[] faceNormals, Vector3D[] normals, int from, int to)
        {
            int[] next = mesh.next, outgoing = mesh.outgoing, face = mesh.face;
            for (int v = from; v < to; v++)
            {
                int start = outgoing[v], h = start;
                if (h < 0)
                    continue;
                double x = 0, y = 0, z = 0;
                do
                {
                    int f = face[h];
                    if (f >= 0)
                    {
                        ref readonly Vector3D normal = ref faceNormals[f];
                        x += normal.X;
                        y += normal.Y;
                        z += normal.Z;
                    }
                    h = next[h ^ 1];
                }
                while (h != start);
                normals[v] = Areas.Unit(new(x, y, z));
            }
        }
    }

    /// <summary>The face's contribution at the corner where the half-edge begins.</summary>
    private static Vector3D CornerNormal(HalfEdge h, VertexNormalWeight weight)
    {
        Vector3D v = h.Source.Position, u = h.Target.Position - v, w = h.Previous.Source.Position - v;
        switch (weight)
        {
            case VertexNormalWeight.Uniform:
                return h.Face.Normal;
            case VertexNormalWeight.Area:
                return h.Face.DoubleAreaVector;
            case VertexNormalWeight.Angle:
                return CornerAngles.AngleAt(h.Previous) * h.Face.Normal;
            case VertexNormalWeight.InscribedSphere:
                double squares = u.LengthSquared * w.LengthSquared;
                return squares > 0 ? Vector3D.Cross(u, w) / squares : default;
            default:
                throw Unknown(weight);
        }
    }

    private static Vector3D[] OfPolygons(Mesh mesh, VertexNormalWeight weight)
    {
        var normals = new Vector3D[mesh.VertexSlots];
        Parallelism.ForBlocks(normals.Length, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                if (!mesh.IsDeletedVertex(v))
                    normals[v] = mesh.Vertices[v].NormalBy(weight);
            }
        });
        return normals;
    }

    /// <summary>In a triangle the cross product at any corner is the face's normal, so one walk around the vertex is all there is to do.</summary>
    private static Vector3D[] OfTriangles<TSum>(Mesh mesh)
        where TSum : struct, INormalSum
    {
        var normals = new Vector3D[mesh.VertexSlots];
        Parallelism.ForBlocks(normals.Length, (from, to) => Block(mesh, normals, from, to));
        return normals;

        static void Block(Mesh mesh, Vector3D[] normals, int from, int to)
        {
            int[] next = mesh.next, target = mesh.target, outgoing = mesh.outgoing, face = mesh.face;
            Vector3D[] positions = mesh.positions;
            for (int v = from; v < to; v++)
            {
                int h = outgoing[v];
                if (h < 0)
                    continue;
                var sum = new TSum();
                CornerSum.Around(next, target, positions, positions[v], h, face[h] < 0, ref sum);
                normals[v] = Areas.Unit(sum.Normal);
            }
        }
    }

    private static ArgumentOutOfRangeException Unknown(VertexNormalWeight weight) => new(nameof(weight), weight, "There is no such weight.");

    internal interface INormalSum : ICornerSum
    {
        Vector3D Normal { get; }
    }

    private struct AreaSum : INormalSum
    {
        public Vector3D Normal { readonly get; private set; }

        public void Add(Vector3D u, Vector3D w) => Normal += Vector3D.Cross(u, w);
    }

    internal struct AngleSum : INormalSum
    {
        public Vector3D Normal { readonly get; private set; }

        public void Add(Vector3D u, Vector3D w)
        {
            Vector3D cross = Vector3D.Cross(u, w);
            double length = cross.Length;
            if (length > 0)
                Normal += cross * (Arctangent.Of(length, Vector3D.Dot(u, w)) / length);
        }
    }

    private struct InscribedSphereSum : INormalSum
    {
        public Vector3D Normal { readonly get; private set; }

        public void Add(Vector3D u, Vector3D w)
        {
            double squares = u.LengthSquared * w.LengthSquared;
            if (squares > 0)
                Normal += Vector3D.Cross(u, w) / squares;
        }
    }
}
