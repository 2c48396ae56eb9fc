using MeshLab.IO;
using MeshLab.Structure;
using Xunit;

namespace MeshLab.Tests.IO;

/// <summary>
/// Odd, damaged and non-manifold files, each with the outcome that a careful user would want. The outcomes are judged from the bytes of the files, by hand:
/// whatever can be read without doubt is read whole; a face is never dropped silently; an error says where, by line and column or by element.
/// </summary>
[Trait("Section", "14")]
public class BrokenFilesTests
{
    /// <summary>Loads with so many vertices and faces, and is a valid mesh.</summary>
    private sealed record Loads(int Vertices, int Faces) : Outcome;

    /// <summary>Refused at a line and column; in binary data line 0 and the byte.</summary>
    private sealed record Refused(long Line, long Column) : Outcome;

    /// <summary>Readable, but not an oriented 2-manifold: the error names at least these elements; as raw data so many vertices and faces.</summary>
    private sealed record NotManifold(int Vertices, int Faces, params string[] Elements) : Outcome;

    /// <summary>Not a format of meshes at all, by its extension.</summary>
    private sealed record NotAMesh : Outcome;

    private abstract record Outcome;

    private static readonly SortedDictionary<string, Outcome> Required = new(StringComparer.Ordinal)
    {
        // OBJ from other programs
        ["BoxTextured.ply"] = new Loads(24, 12),
        ["box.obj"] = new Loads(8, 6),
        ["box.mtl"] = new NotAMesh(),
        ["rabbit.mtl"] = new NotAMesh(),
        ["cubevt.obj"] = new Loads(24, 12),
        ["empty.obj"] = new Loads(0, 0), // nothing but a comment, which is a legal OBJ of nothing
        ["face_in_group_name.obj"] = new Loads(1, 0),
        ["jacked.obj"] = new Loads(8, 12),
        ["joined_tetrahedra.obj"] = new NotManifold(5, 8, "v0", "v1", "f0", "f3", "f4", "f7"), // both tetrahedra have the common triangle
        ["nancolor.obj"] = new Loads(8, 12),
        ["negative_indices.obj"] = new Loads(8, 6),
        ["notenoughindices.obj"] = new Refused(9, 10), // "f 1// 2//" ends before a third corner
        ["obj_points.obj"] = new Loads(8, 0),
        ["obj_wireframe.obj"] = new Loads(8, 0),
        ["polygonfaces.obj"] = new Loads(5, 1),
        ["rabbit.obj"] = new Loads(644, 678),
        ["singlevn.obj"] = new Loads(4, 2),
        ["suzanne_quads.obj"] = new Loads(507, 500),
        ["textured_tetrahedron.obj"] = new Loads(4, 4),
        ["two_objects.obj"] = new Loads(12, 16),
        ["wallhole.obj"] = new Loads(92, 13),
        ["beetle_nonmanifold.obj"] = new NotManifold(1148, 2053, "v56", "v62", "f81", "f1550", "f1551"),
        ["cow_nonmanifold_vertex.obj"] = new NotManifold(2903, 5804, "v253"),
        ["truck_nonmanifold.obj"] = new NotManifold(2956, 4770, "v413", "v431", "f1390", "f1555", "f4726"),

        // OBJ by hand
        ["own_bom_cube.obj"] = new Loads(8, 12),
        ["own_bowtie_vertex.obj"] = new NotManifold(5, 2, "v0"),
        ["own_cr_only_cube.obj"] = new Loads(8, 12),
        ["own_crlf_cube.obj"] = new Loads(8, 12),
        ["own_degenerate_index.obj"] = new NotManifold(8, 13, "f12", "v0"),
        ["own_degenerate_zero_area.obj"] = new Loads(9, 3),
        ["own_duplicate_face.obj"] = new NotManifold(8, 13, "f0", "f12", "v1", "v2", "v3"),
        ["own_duplicate_face_flipped.obj"] = new NotManifold(8, 13, "f0", "f12", "v1", "v2", "v3"),
        ["own_duplicate_vertices.obj"] = new Loads(36, 12),
        ["own_inconsistent_orientation.obj"] = new NotManifold(8, 12, "f0"),
        ["own_index_out_of_range.obj"] = new Refused(20, 7), // "f 1 5 100"
        ["own_index_zero.obj"] = new Refused(21, 3), // "f 0 1 2"
        ["own_inf_vertex.obj"] = new Refused(8, 3), // "v inf 1 1"
        ["own_isolated_vertex.obj"] = new Loads(10, 12),
        ["own_nan_vertex.obj"] = new Refused(8, 3), // "v nan nan nan"
        ["own_nonewline_end.obj"] = new Loads(8, 12),
        ["own_nonmanifold_edge.obj"] = new NotManifold(5, 3, "v0", "v1", "f0", "f1", "f2"),
        ["own_truncated.obj"] = new Refused(20, 4), // "f 4" and no more
        ["own_two_closed_at_vertex.obj"] = new NotManifold(7, 8, "v0"),
        ["own_two_vertex_face.obj"] = new Refused(21, 6), // "f 1 2"
        ["own_vertex_colors.obj"] = new Loads(8, 12),
        ["own_w_coordinate.obj"] = new Loads(8, 12),

        // OFF
        ["L_polygon.off"] = new Loads(6, 1),
        ["beetle_binary.off"] = new Refused(1, 5), // the word BINARY
        ["cam.off"] = new NotManifold(5, 2, "v0"),
        ["comments.off"] = new Loads(8, 6),
        ["facecube.off"] = new Loads(8, 6),
        ["hole_capsule_quads.off"] = new Loads(89, 76),
        ["own_COFF.off"] = new Loads(8, 12),
        ["own_COFF_float.off"] = new Loads(8, 12),
        ["own_NOFF.off"] = new Loads(8, 12),
        ["own_STOFF.off"] = new Loads(8, 12),
        ["own_comments_blank_crlf.off"] = new Loads(8, 12),
        ["own_counts_on_first_line.off"] = new Loads(8, 12),
        ["own_face_colors.off"] = new Loads(8, 12),
        ["own_huge_count.off"] = new Refused(4, 1), // two thousand million vertices announced, one given
        ["own_klein_bottle.off"] = new NotManifold(288, 576, "v0", "v1", "f1", "f574"),
        ["own_mixed_polygons.off"] = new Loads(8, 7),
        ["own_moebius.off"] = new NotManifold(48, 48, "v0", "v1", "f0", "f47"),
        ["own_negative_count.off"] = new Refused(2, 1),
        ["own_no_edge_count.off"] = new Loads(8, 12),
        ["own_no_header.off"] = new Loads(8, 12), // legal by Geomview's text
        ["own_truncated.off"] = new Refused(17, 2), // "3" and no more
        ["own_truncated_vertices.off"] = new Refused(5, 1),
        ["unitcube.off"] = new NotManifold(8, 6, "v0", "v1", "f0", "f3"),
        ["vertcube.off"] = new Loads(8, 6),
        ["whitespace.off"] = new Loads(8, 6),

        // STL
        ["empty.stl"] = new Loads(0, 0),
        ["icosahedron_ascii.stl"] = new Loads(12, 20),
        ["icosahedron_binary.stl"] = new Loads(12, 20),
        ["mixed_case.stl"] = new Loads(16, 24),
        ["multibody.stl"] = new NotManifold(20, 32, "v5", "v6"), // one body inside out against the other
        ["own_ascii_upper_crlf.stl"] = new Loads(8, 12),
        ["own_binary_solid_header.stl"] = new Loads(8, 12),
        ["own_extra_bytes_binary.stl"] = new Loads(8, 12),
        ["own_truncated_ascii.stl"] = new Refused(68, 47), // ends after the facet's second vertex
        ["own_truncated_binary.stl"] = new Refused(0, 624),
        ["own_zero_facets_binary.stl"] = new Loads(0, 0),
        ["shared.stl"] = new NotManifold(14, 24, "v0", "v2"),
        ["soup.stl"] = new Loads(300, 100),

        // PLY
        ["cube_blender_uv.ply"] = new Loads(24, 6),
        ["empty.ply"] = new Loads(0, 0),
        ["metadata.ply"] = new Loads(4, 2),
        ["multi.ply"] = new Loads(4, 1),
        ["own_ascii.ply"] = new Loads(8, 12),
        ["own_ascii_vertex_index.ply"] = new Loads(8, 12),
        ["own_binary_be.ply"] = new Loads(8, 12),
        ["own_binary_le_double.ply"] = new Loads(8, 12),
        ["own_binary_le_intlist.ply"] = new Loads(8, 6),
        ["own_crlf_header.ply"] = new Loads(8, 12),
        ["own_extra_properties.ply"] = new Loads(3, 1),
        ["own_faces_before_vertices.ply"] = new Loads(3, 1),
        ["own_tristrips.ply"] = new Loads(4, 2),
        ["own_truncated_ascii.ply"] = new Refused(27, 3), // "3 " and no more
        ["own_truncated_binary.ply"] = new Refused(0, 404),
        ["plane.ply"] = new Loads(4, 1),
        ["points_ascii_with_lists.ply"] = new Loads(5, 0),
        ["points_only.ply"] = new Loads(5, 0),
        ["tet.ply"] = new Loads(4, 4),
    };

    public static TheoryData<string> Files => new(Required.Keys);

    [SkippableFact]
    public void Table_AgainstTheFolder_NamesEveryFile()
    {
        IEnumerable<string> files = ReferenceData.Json("broken").RootElement.EnumerateObject().Select(p => p.Name);
        Assert.Equal(files.Order(StringComparer.Ordinal), Required.Keys, StringComparer.Ordinal);
    }

    [SkippableTheory]
    [MemberData(nameof(Files))]
    public void Read_OddFile_HasTheRequiredOutcome(string name)
    {
        string path = ReferenceData.FilePath("models", "broken", name);
        switch (Required[name])
        {
            case Loads loads:
                Mesh mesh = MeshFile.Read(path);
                Assert.Equal((loads.Vertices, loads.Faces), (mesh.Vertices.Count, mesh.Faces.Count));
                Assert.Empty(mesh.Validate());
                break;

            case Refused refused:
                MeshFormatException error = Assert.Throws<MeshFormatException>(() => MeshFile.Read(path));
                Assert.True((refused.Line, refused.Column) == (error.Line, error.Column), error.Message);
                Assert.StartsWith(path + ":", error.Message, StringComparison.Ordinal);
                break;

            case NotManifold bad:
                TopologyException topology = Assert.Throws<TopologyException>(() => MeshFile.Read(path));
                Assert.All(bad.Elements, e => Assert.Contains(e, topology.Elements, StringComparer.Ordinal));
                MeshData data = MeshFile.ReadData(path);
                Assert.Equal((bad.Vertices, bad.Faces), (data.VertexCount, data.FaceCount));
                break;

            default:
                Assert.Throws<ArgumentException>(() => MeshFile.Read(path));
                break;
        }
    }

    [SkippableTheory]
    [MemberData(nameof(Files))]
    public void Read_OddFileWithRepair_ReportsEveryFaceLeftOut(string name)
    {
        string path = ReferenceData.FilePath("models", "broken", name);
        if (Required[name] is not NotManifold bad)
            return;
        Mesh skipped = MeshFile.Read(path, out MeshReadReport report, new MeshReadOptions { NonManifold = NonManifoldPolicy.Skip });
        Assert.Empty(skipped.Validate());
        Assert.Equal(bad.Faces, skipped.Faces.Count + report.Build!.Repairs.Count(r => r.Kind == RepairKind.SkippedFace));

        Mesh split = MeshFile.Read(path, out report, new MeshReadOptions { NonManifold = NonManifoldPolicy.Split });
        Assert.Empty(split.Validate());
        Assert.Equal(bad.Faces, split.Faces.Count + report.Build!.Repairs.Count(r => r.Kind == RepairKind.SkippedFace));
    }

    [SkippableFact]
    public void Read_OddFiles_KeepWhatTheySayBesideFaces()
    {
        MeshData Data(string name, out MeshReadReport report) => MeshFile.ReadData(ReferenceData.FilePath("models", "broken", name), out report);

        MeshData box = Data("box.obj", out MeshReadReport report);
        Assert.Equal(["box.mtl"], report.MaterialLibraries);
        FaceLabelSet material = Assert.Single(box.FaceLabels, l => l.Kind == FaceLabelSet.Material);
        Assert.Equal(["Material", "SecondMaterial"], material.Names);
        Assert.Equal([0, 0, 0, 0, 1, 1], material.Labels);
        Assert.NotNull(box.CornerTextureCoordinates);

        Data("obj_wireframe.obj", out report);
        Assert.Equal(12, report.Ignored["l"]);
        Assert.Equal(12, report.IgnoredLines);

        MeshData colors = Data("nancolor.obj", out report);
        Assert.Equal(1, report.ReplacedAttributes);
        Assert.Equal(MeshLab.Numerics.Color.White, colors.VertexColors![6]);

        Data("own_extra_bytes_binary.stl", out report);
        Assert.Equal(37, report.TrailingBytes);
        Data("metadata.ply", out report);
        Assert.Equal(1, report.Ignored["property face.face_type"]);
        Assert.Equal([0, 1, 2, 2, 1, 3], Data("own_tristrips.ply", out _).Corners);
        Assert.Equal(["CubeExportedFromCAD", "TranslatedCubeExportedFromCAD"], Data("mixed_case.stl", out _).FaceLabels.Single().Names);
    }
}
