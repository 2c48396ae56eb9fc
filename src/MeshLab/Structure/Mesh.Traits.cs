using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;

namespace MeshLab.Structure;

/// <summary>The registry of traits.</summary>
public sealed partial class Mesh
{
    private readonly List<Trait> vertexTraits = [];
    private readonly List<Trait> halfEdgeTraits = [];
    private readonly List<Trait> edgeTraits = [];
    private readonly List<Trait> faceTraits = [];
    private readonly List<FaceLabels> faceLabels = [];

    /// <summary>The vertex traits that exist, in order of addition.</summary>
    public IReadOnlyList<Trait> VertexTraits => vertexTraits;

    /// <summary>The half-edge traits that exist.</summary>
    public IReadOnlyList<Trait> HalfEdgeTraits => halfEdgeTraits;

    /// <summary>The edge traits that exist.</summary>
    public IReadOnlyList<Trait> EdgeTraits => edgeTraits;

    /// <summary>The face traits that exist.</summary>
    public IReadOnlyList<Trait> FaceTraits => faceTraits;

    /// <summary>The sorts of named face groups that exist: materials, groups, objects.</summary>
    public IReadOnlyList<FaceLabels> FaceLabels => faceLabels;

    /// <summary>The textbook's traits of the whole mesh: bounding box and sphere.</summary>
    public MeshTraits Traits => new(this);

    internal IEnumerable<Trait> AllTraits => vertexTraits.Concat(halfEdgeTraits).Concat(edgeTraits).Concat(faceTraits);

    /// <summary>Adds a value per vertex.</summary>
    /// <typeparam name="T">The type of the values.</typeparam>
    /// <param name="name">A name that no other vertex trait has.</param>
    /// <param name="defaultValue">What every vertex, and every new one, gets.</param>
    /// <param name="blend">How an operation mixes two values; the nearer one's if not given.</param>
    /// <exception cref="ArgumentException">The name is taken.</exception>
    public VertexTrait<T> AddVertexTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        Register(vertexTraits, new VertexTrait<T>(this, name, defaultValue, blend));

    /// <summary>Adds a value per half-edge (corner).</summary>
    /// <inheritdoc cref="AddVertexTrait{T}"/>
    public HalfEdgeTrait<T> AddHalfEdgeTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        Register(halfEdgeTraits, new HalfEdgeTrait<T>(this, name, defaultValue, blend));

    /// <summary>Adds a value per edge.</summary>
    /// <inheritdoc cref="AddVertexTrait{T}"/>
    public EdgeTrait<T> AddEdgeTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        Register(edgeTraits, new EdgeTrait<T>(this, name, defaultValue, blend));

    /// <summary>Adds a value per face.</summary>
    /// <inheritdoc cref="AddVertexTrait{T}"/>
    public FaceTrait<T> AddFaceTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        Register(faceTraits, new FaceTrait<T>(this, name, defaultValue, blend));

    /// <summary>Looks a vertex trait up.</summary>
    /// <returns>Whether there is one of that name and type.</returns>
    public bool TryGetVertexTrait<T>(string name, [NotNullWhen(true)] out VertexTrait<T>? trait) =>
        (trait = Find(vertexTraits, name) as VertexTrait<T>) is not null;

    /// <summary>Looks a half-edge trait up.</summary>
    /// <inheritdoc cref="TryGetVertexTrait{T}"/>
    public bool TryGetHalfEdgeTrait<T>(string name, [NotNullWhen(true)] out HalfEdgeTrait<T>? trait) =>
        (trait = Find(halfEdgeTraits, name) as HalfEdgeTrait<T>) is not null;

    /// <summary>Looks an edge trait up.</summary>
    /// <inheritdoc cref="TryGetVertexTrait{T}"/>
    public bool TryGetEdgeTrait<T>(string name, [NotNullWhen(true)] out EdgeTrait<T>? trait) =>
        (trait = Find(edgeTraits, name) as EdgeTrait<T>) is not null;

    /// <summary>Looks a face trait up.</summary>
    /// <inheritdoc cref="TryGetVertexTrait{T}"/>
    public bool TryGetFaceTrait<T>(string name, [NotNullWhen(true)] out FaceTrait<T>? trait) =>
        (trait = Find(faceTraits, name) as FaceTrait<T>) is not null;

    /// <summary>Removes a trait of this mesh; its column is no longer kept up.</summary>
    /// <returns>Whether it was there.</returns>
    public bool RemoveTrait(Trait trait)
    {
        ArgumentNullException.ThrowIfNull(trait);
        faceLabels.RemoveAll(labels => ReferenceEquals(labels.Labels, trait));
        return TraitsOf(trait.Kind).Remove(trait);
    }

    /// <summary>The named face groups of a sort; added, with no face in any group, if they are not there.</summary>
    public FaceLabels GetOrAddFaceLabels(string sort)
    {
        ArgumentException.ThrowIfNullOrEmpty(sort);
        FaceLabels? found = faceLabels.Find(labels => labels.Sort == sort);
        if (found is null)
        {
            found = new FaceLabels(sort, AddFaceTrait(sort, Structure.FaceLabels.None), []);
            faceLabels.Add(found);
        }
        return found;
    }

    internal VertexTrait<T> GetOrAddVertexTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        TryGetVertexTrait(name, out VertexTrait<T>? trait) ? trait : AddVertexTrait(name, defaultValue, blend);

    internal HalfEdgeTrait<T> GetOrAddHalfEdgeTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        TryGetHalfEdgeTrait(name, out HalfEdgeTrait<T>? trait) ? trait : AddHalfEdgeTrait(name, defaultValue, blend);

    internal EdgeTrait<T> GetOrAddEdgeTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        TryGetEdgeTrait(name, out EdgeTrait<T>? trait) ? trait : AddEdgeTrait(name, defaultValue, blend);

    internal FaceTrait<T> GetOrAddFaceTrait<T>(string name, T defaultValue = default!, TraitBlend<T>? blend = null) =>
        TryGetFaceTrait(name, out FaceTrait<T>? trait) ? trait : AddFaceTrait(name, defaultValue, blend);

    internal List<Trait> TraitsOf(ElementKind kind) => kind switch
    {
        ElementKind.Vertex => vertexTraits,
        ElementKind.HalfEdge => halfEdgeTraits,
        ElementKind.Edge => edgeTraits,
        _ => faceTraits,
    };

    /// <summary>Gives an element the traits of another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void CopyTraits(ElementKind kind, int from, int to)
    {
        List<Trait> traits = TraitsOf(kind);
        for (int i = 0; i < traits.Count; i++)
            traits[i].Copy(from, to);
    }

    /// <summary>Gives an element the blend of the traits of two others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void MixTraits(ElementKind kind, int to, int first, int second, double t)
    {
        List<Trait> traits = TraitsOf(kind);
        for (int i = 0; i < traits.Count; i++)
            traits[i].Mix(to, first, second, t);
    }

    /// <summary>Gives this mesh, which has no traits of the kind yet, those of a mesh that it was made from.</summary>
    /// <inheritdoc cref="Trait.Derive"/>
    internal void DeriveTraits(Mesh source, ElementKind kind, int[] first, int[]? second = null, double[]? t = null)
    {
        foreach (Trait theirs in source.TraitsOf(kind))
        {
            Trait mine = theirs.CloneFor(this);
            mine.Derive(theirs, first, second, t);
            TraitsOf(kind).Add(mine);
        }
        if (kind != ElementKind.Face)
            return;
        foreach (FaceLabels labels in source.faceLabels)
            faceLabels.Add(new FaceLabels(labels.Sort, (FaceTrait<int>)Find(faceTraits, labels.Labels.Name)!, labels.Names));
    }

    internal int SlotsOf(ElementKind kind) => kind switch
    {
        ElementKind.Vertex => vertexSlots,
        ElementKind.HalfEdge => halfEdgeSlots,
        ElementKind.Edge => EdgeSlots,
        _ => faceSlots,
    };

    private static Trait? Find(List<Trait> traits, string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        foreach (Trait trait in traits)
        {
            if (trait.Name == name)
                return trait;
        }
        return null;
    }

    private static TTrait Register<TTrait>(List<Trait> traits, TTrait trait)
        where TTrait : Trait
    {
        ArgumentException.ThrowIfNullOrEmpty(trait.Name);
        if (Find(traits, trait.Name) is not null)
            throw new ArgumentException($"The mesh has a {trait.Kind} trait of the name \"{trait.Name}\" already.");
        traits.Add(trait);
        return trait;
    }

    private void ResizeTraits()
    {
        foreach (Trait trait in AllTraits)
            trait.Grow(SlotsOf(trait.Kind));
    }

    private void CopyTraitsFrom(Mesh other)
    {
        foreach (Trait trait in other.AllTraits)
            TraitsOf(trait.Kind).Add(trait.CloneFor(this));
        foreach (FaceLabels labels in other.faceLabels)
        {
            var copy = (FaceTrait<int>)Find(faceTraits, labels.Labels.Name)!;
            faceLabels.Add(new FaceLabels(labels.Sort, copy, labels.Names));
        }
    }
}
