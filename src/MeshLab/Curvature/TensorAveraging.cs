using MeshLab.Geometry;
using MeshLab.Numerics;
using MeshLab.Structure;

namespace MeshLab.Curvature;

/// <summary>§10.8.2 The curvature tensor of each face from the normals of its corners, averaged at the vertices (Rusinkiewicz 2004).</summary>
/// <remarks>
/// In a face with unit axes x, y the tensor II = ((e, f), (f, g)) should turn every side into the difference of the normals at its ends,
/// II · (s·x, s·y) = (Δn·x, Δn·y): six equations for three numbers, solved by least squares. At a vertex the face's plane is turned onto the
/// tangent plane and the tensors are averaged with the face's part of the mixed area as weight. Eigenvalues and eigenvectors are curvatures and
/// directions. Works on the boundary too. O(V + H), in parallel.
/// </remarks>
public static class TensorAveraging
{
    /// <summary>The principal curvatures and directions of every vertex.</summary>
    /// <exception cref="ArgumentException">A face is not a triangle.</exception>
    public static PrincipalCurvatures Compute(Mesh mesh)
    {
        mesh.RequireTriangles();
        Vector3D[] faceNormals = mesh.ComputeFaceNormals(), vertexNormals = mesh.ComputeVertexNormals();
        var tensors = new SymmetricTensor2[mesh.FaceSlots];
        Parallelism.ForBlocks(tensors.Length, (from, to) =>
        {
            for (int f = from; f < to; f++)
            {
                if (faceNormals[f] != default)
                    tensors[f] = OfFace(mesh, f, faceNormals[f], vertexNormals);
            }
        });

        PrincipalCurvatures result = PrincipalCurvatures.Undefined(mesh.VertexSlots);
        Parallelism.ForBlocks(mesh.VertexSlots, (from, to) =>
        {
            for (int v = from; v < to; v++)
            {
                if (vertexNormals[v] != default)
                    AtVertex(mesh, v, vertexNormals[v], faceNormals, tensors, result);
            }
        });
        return result;
    }

    /// <summary>The least-squares tensor of a face in the frame of its normal.</summary>
    private static SymmetricTensor2 OfFace(Mesh mesh, int f, Vector3D normal, Vector3D[] vertexNormals)
    {
        var frame = new TangentFrame(normal);
        // Normal equations of sx·e + sy·f = dx and sx·f + sy·g = dy.
        double xx = 0, xy = 0, yy = 0, right0 = 0, right1 = 0, right2 = 0;
        int first = mesh.halfEdgeOf[f], h = first;
        do
        {
            int from = mesh.target[h ^ 1], to = mesh.target[h];
            Vector3D side = mesh.positions[to] - mesh.positions[from], change = vertexNormals[to] - vertexNormals[from];
            double sx = Vector3D.Dot(side, frame.X), sy = Vector3D.Dot(side, frame.Y);
            double dx = Vector3D.Dot(change, frame.X), dy = Vector3D.Dot(change, frame.Y);
            xx += sx * sx;
            xy += sx * sy;
            yy += sy * sy;
            right0 += sx * dx;
            right1 += sy * dx + sx * dy;
            right2 += sy * dy;
            h = mesh.next[h];
        }
        while (h != first);
        return Solve(xx, xy, yy, right0, right1, right2);
    }

    /// <summary>Solves ((xx, xy, 0), (xy, xx + yy, xy), (0, xy, yy)) · (e, f, g) = right.</summary>
    private static SymmetricTensor2 Solve(double xx, double xy, double yy, double right0, double right1, double right2)
    {
        double middle = xx + yy;
        double determinant = xx * (middle * yy - xy * xy) - xy * xy * yy;
        if (!(determinant > 0))
            return default;
        double e = right0 * (middle * yy - xy * xy) - right1 * xy * yy + right2 * xy * xy;
        double f = -right0 * xy * yy + right1 * xx * yy - right2 * xx * xy;
        double g = right0 * xy * xy - right1 * xx * xy + right2 * (xx * middle - xy * xy);
        return new(e / determinant, f / determinant, g / determinant);
    }

    private static void AtVertex(
        Mesh mesh, int v, Vector3D normal, Vector3D[] faceNormals, SymmetricTensor2[] tensors, PrincipalCurvatures result)
    {
        var frame = new TangentFrame(normal);
        Vector3D center = mesh.positions[v];
        double e = 0, f = 0, g = 0, weights = 0;
        int start = mesh.outgoing[v], h = start;
        do
        {
            int face = mesh.face[h];
            if (face >= 0 && faceNormals[face] != default)
            {
                Vector3D u = mesh.positions[mesh.target[h]] - center, w = mesh.positions[mesh.target[mesh.next[h]]] - center;
                double weight = VertexAreas.MixedPart(Vector3D.Cross(u, w).Length, u.LengthSquared, Vector3D.Dot(u, w), w.LengthSquared);
                SymmetricTensor2 turned = Turn(tensors[face], faceNormals[face], normal, frame);
                e += weight * turned.E;
                f += weight * turned.F;
                g += weight * turned.G;
                weights += weight;
            }
            h = mesh.next[h ^ 1];
        }
        while (h != start);
        if (weights > 0)
            new SymmetricTensor2(e / weights, f / weights, g / weights).Store(result, v, frame.X, frame.Y);
    }

    /// <summary>The face's tensor in the vertex's frame, after the frame was turned about the common line onto the face's plane.</summary>
    private static SymmetricTensor2 Turn(SymmetricTensor2 tensor, Vector3D faceNormal, Vector3D vertexNormal, TangentFrame frame)
    {
        var own = new TangentFrame(faceNormal);
        Vector3D x = Onto(frame.X, vertexNormal, faceNormal), y = Onto(frame.Y, vertexNormal, faceNormal);
        double xx = Vector3D.Dot(x, own.X), xy = Vector3D.Dot(x, own.Y), yx = Vector3D.Dot(y, own.X), yy = Vector3D.Dot(y, own.Y);
        return new(
            tensor.Along(xx, xy),
            tensor.E * xx * yx + tensor.F * (xx * yy + xy * yx) + tensor.G * xy * yy,
            tensor.Along(yx, yy));
    }

    /// <summary>A vector after the least rotation that takes one unit normal to another.</summary>
    private static Vector3D Onto(Vector3D vector, Vector3D from, Vector3D to)
    {
        double cos = Vector3D.Dot(from, to);
        // Opposite normals: every axis does, so keep the vector and turn its sense.
        if (cos <= -1 + 1e-12)
            return -vector;
        return vector - (from + to) * (Vector3D.Dot(vector, to) / (1 + cos));
    }
}
