using MeshLab.Numerics;

namespace MeshLab.HoleFilling;

/// <summary>§6.1 (c) 最小角 (advancing front): cuts off the corner with the smallest angle, again and again, until three are left.</summary>
/// <remarks>
/// The angle is measured on the side of the hole, from 0 to 2π, by the normals of the triangles beside the front: a corner that bends away from the hole is reflex and
/// waits. A corner is passed over if its chord is an edge of the mesh already, or if another vertex of the front lies above the triangle, which
/// would fold the patch. If every corner is passed over, that with the smallest angle whose chord is free goes. O(n²) mostly.
/// </remarks>
internal static class EarTriangulation
{
    /// <summary>The triangles, three numbers each, or <see langword="null"/> if every chord left is taken.</summary>
    public static List<int>? Triangulate(HoleLoop loop, CancellationToken cancellationToken)
    {
        var front = new Front(loop);
        var triangles = new List<int>(3 * (loop.Count - 2));
        while (front.Left > 3)
        {
            cancellationToken.ThrowIfCancellationRequested();
            int corner = front.Choose();
            if (corner < 0)
                return null;
            triangles.AddRange([front.Before(corner), corner, front.After(corner)]);
            front.CutOff(corner);
        }
        front.LastThree(triangles);
        return triangles;
    }

    private sealed class Front
    {
        private readonly HoleLoop loop;
        private readonly int[] next;
        private readonly int[] previous;
        private readonly double[] angle;
        private readonly Vector3D[] normalBehind;
        private readonly PriorityQueue<(int Corner, int Round), (double Angle, int Corner)> queue = new();
        private readonly int[] round;
        private int any;

        public Front(HoleLoop loop)
        {
            this.loop = loop;
            int n = Left = loop.Count;
            next = new int[n];
            previous = new int[n];
            angle = new double[n];
            round = new int[n];
            normalBehind = [.. loop.RimNormals];
            for (int i = 0; i < n; i++)
            {
                next[i] = (i + 1) % n;
                previous[i] = (i + n - 1) % n;
            }
            for (int i = 0; i < n; i++)
                Enqueue(i);
        }

        public int Left { get; private set; }

        public int Before(int i) => previous[i];

        public int After(int i) => next[i];

        /// <summary>The corner to cut off, −1 if none can be.</summary>
        public int Choose()
        {
            var passedOver = new List<int>();
            int found = -1, least = -1;
            while (found < 0 && queue.TryDequeue(out var entry, out _))
            {
                int i = entry.Corner;
                if (entry.Round != round[i] || next[i] < 0)
                    continue;
                if (loop.IsTaken(previous[i], next[i]))
                {
                    passedOver.Add(i);
                    continue;
                }
                if (least < 0)
                    least = i;
                if (angle[i] < Math.PI && !Covers(i))
                    found = i;
                else
                    passedOver.Add(i);
            }
            foreach (int i in passedOver)
                queue.Enqueue((i, round[i]), (angle[i], i));
            return found >= 0 ? found : least;
        }

        public void CutOff(int i)
        {
            int a = previous[i], b = next[i];
            normalBehind[a] = Vector3D.Cross(loop.Points[i] - loop.Points[a], loop.Points[b] - loop.Points[a]).Normalized();
            next[a] = b;
            previous[b] = a;
            next[i] = -1;
            Left--;
            any = a;
            Enqueue(a);
            Enqueue(b);
        }

        public void LastThree(List<int> triangles) => triangles.AddRange([any, next[any], next[next[any]]]);

        private void Enqueue(int i)
        {
            Vector3D p = loop.Points[i], ahead = loop.Points[next[i]] - p, back = loop.Points[previous[i]] - p;
            Vector3D up = normalBehind[i] + normalBehind[previous[i]];
            double opening = Vector3D.Angle(ahead, back);
            // The hole is to the left of the front: a right turn opens more than half around.
            angle[i] = Vector3D.Dot(Vector3D.Cross(ahead, back), up) >= 0 ? opening : 2 * Math.PI - opening;
            queue.Enqueue((i, ++round[i]), (angle[i], i));
        }

        /// <summary>Whether another vertex of the front lies above or below the triangle, near enough to fold the patch.</summary>
        private bool Covers(int i)
        {
            Vector3D a = loop.Points[previous[i]], b = loop.Points[i], c = loop.Points[next[i]];
            Vector3D n = Vector3D.Cross(b - a, c - a);
            double size = n.LengthSquared;
            if (size == 0)
                return true;
            for (int k = next[next[i]]; k != previous[i]; k = next[k])
            {
                Vector3D p = loop.Points[k];
                double height = Vector3D.Dot(p - a, n);
                // Height against the length of an edge: height² / |n|² < |n|.
                if (height * height > size * Math.Sqrt(size) || p == a || p == b || p == c)
                    continue;
                if (Vector3D.Dot(Vector3D.Cross(b - a, p - a), n) >= 0 && Vector3D.Dot(Vector3D.Cross(c - b, p - b), n) >= 0 && Vector3D.Dot(Vector3D.Cross(a - c, p - c), n) >= 0)
                    return true;
            }
            return false;
        }
    }
}
