using MeshLab.Editing;
using MeshLab.Structure;

namespace MeshLab.Cutting;

/// <summary>§6.3 按三角形面切割: takes faces out of a mesh and makes a mesh of their own from them.</summary>
/// <remarks>The vertices of the rim are in both. Whatever stays keeps its index. A vertex where parts of either mesh met in a point alone gets copies; the result names them. <see cref="Mesh.Append"/> is the way back.</remarks>
public static class FaceDetachment
{
    extension(Mesh mesh)
    {
        /// <summary>Removes the faces from the mesh and returns them as a new one.</summary>
        /// <param name="faces">Faces of the mesh; one named twice does no harm.</param>
        /// <exception cref="ArgumentException">A face is none, deleted or of another mesh; it is named.</exception>
        public MeshPart Detach(IEnumerable<Face> faces)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            List<int> chosen = Chosen(mesh, faces);
            MeshPart part = MeshPart.OfFaces(mesh, chosen);
            if (chosen.Count == 0)
                return part;
            using OperationScope operation = mesh.BeginOperation(OperationKind.DeleteFace, chosen[0]);
            var copies = new List<int>();
            RegionRemoval.Remove(mesh, chosen, new RemovalOptions { SplitPinched = true }, copies);
            operation.Complete();
            return part with { CopiesLeftBehind = copies };
        }

        /// <summary>The faces as a new mesh; the mesh given stays as it is.</summary>
        /// <inheritdoc cref="Detach"/>
        public MeshPart Extract(IEnumerable<Face> faces)
        {
            ArgumentNullException.ThrowIfNull(mesh);
            return MeshPart.OfFaces(mesh, Chosen(mesh, faces));
        }
    }

    private static List<int> Chosen(Mesh mesh, IEnumerable<Face> faces)
    {
        ArgumentNullException.ThrowIfNull(faces);
        var isChosen = new bool[mesh.FaceSlots];
        foreach (Face f in faces)
        {
            mesh.CheckOwn(f, nameof(faces));
            isChosen[f.index] = true;
        }
        var chosen = new List<int>();
        for (int f = 0; f < isChosen.Length; f++)
        {
            if (isChosen[f])
                chosen.Add(f);
        }
        return chosen;
    }
}
