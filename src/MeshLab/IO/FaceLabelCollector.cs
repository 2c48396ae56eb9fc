namespace MeshLab.IO;

/// <summary>Turns "from face f on, the material is m" into a label per face. Names that no face has are left out.</summary>
internal sealed class FaceLabelCollector(int faces)
{
    private readonly List<Set> sets = [];

    /// <summary>From the face on, the kind's name is another; an empty name is none.</summary>
    public void Change(string kind, int face, string name)
    {
        Set? set = sets.Find(s => s.Kind == kind);
        if (set is null)
        {
            set = new Set(kind, faces);
            sets.Add(set);
        }

        set.FillTo(face);
        set.Current = name;
    }

    /// <summary>The sets in which some face has a label, in a fixed order of kinds.</summary>
    public FaceLabelSet[] ToSets()
    {
        foreach (Set set in sets)
            set.FillTo(faces);
        return [.. sets.Where(s => s.Names.Count > 0).OrderBy(s => s.Kind, StringComparer.Ordinal).Select(s => new FaceLabelSet(s.Kind, s.Names, s.Labels))];
    }

    private sealed class Set
    {
        private readonly Dictionary<string, int> indices = new(StringComparer.Ordinal);
        private int filled;

        public Set(string kind, int faces)
        {
            Kind = kind;
            Labels = new int[faces];
        }

        public string Kind { get; }

        public List<string> Names { get; } = [];

        public int[] Labels { get; }

        public string Current { get; set; } = "";

        public void FillTo(int face)
        {
            if (face == filled)
                return;
            int label = -1;
            if (Current.Length > 0 && !indices.TryGetValue(Current, out label))
            {
                label = Names.Count;
                Names.Add(Current);
                indices.Add(Current, label);
            }

            Labels.AsSpan(filled, face - filled).Fill(label);
            filled = face;
        }
    }
}
