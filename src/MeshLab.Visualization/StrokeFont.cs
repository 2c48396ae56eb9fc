using System.Globalization;
using System.Numerics;

namespace MeshLab.Visualization;

/// <summary>
/// The letters of legends and labels: drawn by strokes of a round pen, so that they need no font file and are smooth at every size.
/// Printable ASCII and the signs that formulas of this field need; another character is an empty box.
/// </summary>
/// <remarks>
/// A glyph is its advance width, then strokes in units of which a capital letter is 70 high, y up, the base line at 0:
/// <c>M x y</c> moves, <c>L x y …</c> draws lines, <c>Q cx cy x y</c> a quadratic curve, <c>O cx cy rx ry from to</c> an elliptical arc (degrees,
/// counter-clockwise if from &lt; to), joined to what came before by a line unless it follows <c>N</c> (new stroke).
/// </remarks>
internal static class StrokeFont
{
    /// <summary>Height of a capital letter in units.</summary>
    public const float CapHeight = 70;

    private const string Source = """
          26|
        ! 24|M 12 70 L 12 23 N O 12 2 1.5 1.5 0 360
        " 32|M 10 70 L 10 52 M 22 70 L 22 52
        # 56|M 22 66 L 14 4 M 42 66 L 34 4 M 8 46 L 50 46 M 6 24 L 48 24
        $ 48|O 24 49 16 14 30 270 O 24 18 17 17 90 -150 M 24 78 L 24 -8
        % 72|N O 17 53 11 15 0 360 N O 55 17 11 15 0 360 M 54 70 L 18 0
        & 62|M 56 0 L 18 44 O 26 55 13 14 215 -35 Q 38 44 26 38 O 25 18 18 18 110 300 Q 50 12 54 36
        ' 20|M 10 70 L 10 52
        ( 30|M 23 78 Q 8 58 8 32 Q 8 6 23 -14
        ) 30|M 7 78 Q 22 58 22 32 Q 22 6 7 -14
        * 42|M 21 70 L 21 40 M 8 62 L 34 48 M 34 62 L 8 48
        + 54|M 27 54 L 27 10 M 5 32 L 49 32
        , 24|M 13 4 L 13 0 L 8 -13
        - 36|M 6 28 L 30 28
        . 24|N O 12 2 1.5 1.5 0 360
        / 40|M 34 76 L 6 -8
        0 52|N O 26 35 19 35 0 360
        1 52|M 12 56 L 29 70 L 29 0
        2 52|N O 25 51 18 19 165 -25 Q 38 35 7 0 L 45 0
        3 52|N O 24 52.5 16 17.5 150 -90 L 20 35 L 24 35 O 24 17.5 19 17.5 90 -155
        4 52|M 36 0 L 36 70 L 5 20 L 47 20
        5 52|M 42 70 L 13 70 L 10 38 O 25 23 20 23 125 -145
        6 52|M 38 69 Q 8 58 7.5 22 N O 26 22 19 22 0 360
        7 52|M 6 70 L 46 70 L 20 0
        8 52|N O 26 53 16 17 0 360 N O 26 18 19.5 18 0 360
        9 52|M 14 1 Q 44 12 44.5 48 N O 26 48 19 22 0 360
        : 24|N O 12 2 1.5 1.5 0 360 N O 12 44 1.5 1.5 0 360
        ; 24|M 13 4 L 13 0 L 8 -13 N O 12 44 1.5 1.5 0 360
        < 54|M 48 54 L 6 32 L 48 10
        = 54|M 6 42 L 48 42 M 6 22 L 48 22
        > 54|M 6 54 L 48 32 L 6 10
        ? 46|N O 22 53 15 17 165 -45 Q 22 34 22 20 N O 22 2 1.5 1.5 0 360
        @ 78|N O 39 28 12 14 0 360 M 52 42 L 51 22 O 59 22 8 9 180 330 O 39 28 32 36 10 300
        A 58|M 4 0 L 29 70 L 54 0 M 13 24 L 45 24
        B 56|M 10 0 L 10 70 L 30 70 O 30 53 17 17 90 -90 L 10 36 M 30 36 O 30 18 20 18 90 -90 L 10 0
        C 60|N O 33 35 27 35 45 315
        D 62|M 10 0 L 10 70 L 26 70 O 26 35 30 35 90 -90 L 10 0
        E 52|M 46 70 L 10 70 L 10 0 L 46 0 M 10 37 L 40 37
        F 49|M 45 70 L 10 70 L 10 0 M 10 36 L 39 36
        G 64|N O 33 35 27 35 48 315 Q 58 14 58 32 L 38 32
        H 62|M 10 70 L 10 0 M 52 70 L 52 0 M 10 37 L 52 37
        I 22|M 11 70 L 11 0
        J 46|M 36 70 L 36 20 O 21 20 15 20 0 -165
        K 56|M 10 70 L 10 0 M 48 70 L 10 26 M 23 41 L 51 0
        L 48|M 10 70 L 10 0 L 44 0
        M 72|M 10 0 L 10 70 L 36 14 L 62 70 L 62 0
        N 62|M 10 0 L 10 70 L 52 0 L 52 70
        O 68|N O 34 35 28 35 0 360
        P 54|M 10 0 L 10 70 L 30 70 O 30 51 19 19 90 -90 L 10 32
        Q 68|N O 34 35 28 35 0 360 M 40 18 L 60 -6
        R 56|M 10 0 L 10 70 L 30 70 O 30 52 18.5 18 90 -90 L 10 34 M 30 34 L 50 0
        S 54|N O 27 52 18 18 35 270 O 27 17 20 17 90 -150
        T 54|M 4 70 L 50 70 M 27 70 L 27 0
        U 61|M 10 70 L 10 22 O 30.5 22 20.5 22 180 360 L 51 70
        V 56|M 4 70 L 28 0 L 52 70
        W 82|M 4 70 L 22 0 L 41 62 L 60 0 L 78 70
        X 56|M 6 70 L 50 0 M 50 70 L 6 0
        Y 54|M 4 70 L 27 34 L 50 70 M 27 34 L 27 0
        Z 54|M 7 70 L 47 70 L 6 0 L 49 0
        [ 30|M 24 78 L 10 78 L 10 -12 L 24 -12
        \ 40|M 6 76 L 34 -8
        ] 30|M 6 78 L 20 78 L 20 -12 L 6 -12
        ^ 48|M 8 42 L 24 68 L 40 42
        _ 46|M 2 -10 L 44 -10
        ` 28|M 8 72 L 18 60
        a 48|M 40 49 L 40 0 N O 23.5 24.5 16.5 25 0 360
        b 50|M 9 72 L 9 0 N O 26 24.5 17 25 0 360
        c 44|N O 25 24.5 18 25 50 310
        d 50|M 41 72 L 41 0 N O 24 24.5 17 25 0 360
        e 48|M 7 26 L 41.5 26 O 24 24.5 17.5 25 0 318
        f 31|M 29 70 Q 14 73 14 58 L 14 0 M 4 47 L 27 47
        g 50|M 41 49 L 41 2 O 24 2 17 20 0 -150 N O 24 24.5 17 25 0 360
        h 49|M 9 72 L 9 0 M 9 28 O 24.5 31 15.5 18.5 180 0 L 40 0
        i 20|M 10 49 L 10 0 N O 10 65 1.5 1.5 0 360
        j 22|M 12 49 L 12 -6 Q 12 -19 -1 -18 N O 12 65 1.5 1.5 0 360
        k 45|M 9 72 L 9 0 M 38 49 L 9 19 M 19 29 L 41 0
        l 20|M 10 72 L 10 0
        m 75|M 9 49 L 9 0 M 9 31 O 23.5 34 14.5 15.5 180 0 L 38 0 M 38 31 O 52.5 34 14.5 15.5 180 0 L 67 0
        n 49|M 9 49 L 9 0 M 9 28 O 24.5 31 15.5 18.5 180 0 L 40 0
        o 50|N O 25 24.5 18 25 0 360
        p 50|M 9 49 L 9 -20 N O 26 24.5 17 25 0 360
        q 50|M 41 49 L 41 -20 N O 24 24.5 17 25 0 360
        r 33|M 9 49 L 9 0 M 9 28 Q 11 49 30 48
        s 42|N O 21 36 13 13 35 270 O 21 11.5 15 11.5 90 -150
        t 31|M 14 64 L 14 13 Q 14 -2 28 1 M 4 48 L 27 48
        u 49|M 9 49 L 9 18 O 24.5 18 15.5 18.5 180 360 M 40 49 L 40 0
        v 44|M 4 49 L 22 0 L 40 49
        w 66|M 4 49 L 18 0 L 33 43 L 48 0 L 62 49
        x 44|M 5 49 L 39 0 M 39 49 L 5 0
        y 44|M 5 49 L 22.5 2 M 40 49 L 21 -4 Q 15 -20 4 -18
        z 43|M 6 49 L 37 49 L 5 0 L 39 0
        { 32|M 25 78 Q 15 78 15 66 L 15 44 Q 15 33 6 33 Q 15 33 15 22 L 15 0 Q 15 -12 25 -12
        | 22|M 11 78 L 11 -14
        } 32|M 7 78 Q 17 78 17 66 L 17 44 Q 17 33 26 33 Q 17 33 17 22 L 17 0 Q 17 -12 7 -12
        ~ 54|M 6 26 Q 14 42 27 32 Q 40 22 48 38
        − 54|M 6 32 L 48 32
        – 46|M 6 28 L 40 28
        × 54|M 10 49 L 44 15 M 44 49 L 10 15
        · 24|N O 12 28 1.5 1.5 0 360
        ± 54|M 27 62 L 27 22 M 7 42 L 47 42 M 7 6 L 47 6
        ° 32|N O 16 58 10 11 0 360
        ² 32|N O 15 63 9 9 165 -30 Q 22 55 6 38 L 26 38
        ³ 32|N O 15 64.5 8 7.5 150 -90 O 15 47.5 9.5 9.5 90 -155
        √ 56|M 4 34 L 12 38 L 24 2 L 38 78 L 56 78
        ≤ 54|M 48 64 L 8 42 L 48 20 M 8 4 L 48 4
        ≥ 54|M 8 64 L 48 42 L 8 20 M 8 4 L 48 4
        ≠ 54|M 6 42 L 48 42 M 6 22 L 48 22 M 38 60 L 16 4
        ∞ 68|M 34 32 Q 46 50 54 46 Q 64 42 62 30 Q 58 14 48 18 Q 42 20 34 32 Q 26 44 20 46 Q 10 50 6 36 Q 6 18 16 18 Q 24 18 34 32
        → 66|M 6 32 L 60 32 M 44 46 L 60 32 L 44 18
        α 56|M 50 49 Q 42 0 24 0 O 24 24.5 17 24.5 -90 -270 Q 40 49 50 0
        β 52|M 10 -20 L 10 52 O 25 52 15 18 180 -90 M 20 36 L 25 36 O 25 18 18 18 90 -130 L 10 6
        γ 46|M 4 46 Q 12 54 18 36 L 24 -4 M 42 49 L 24 -4 L 21 -20
        θ 50|N O 25 35 17 36 0 360 M 9 36 L 41 36
        κ 46|M 9 49 L 9 0 M 38 49 L 9 19 M 19 29 L 41 0
        λ 46|M 8 70 Q 16 72 19 60 L 41 0 M 24 44 L 6 0
        μ 49|M 9 49 L 9 -20 M 9 18 O 24.5 18 15.5 18.5 180 360 M 40 49 L 40 0
        µ 49|M 9 49 L 9 -20 M 9 18 O 24.5 18 15.5 18.5 180 360 M 40 49 L 40 0
        π 54|M 5 48 L 49 48 M 17 48 L 15 0 M 37 48 L 37 10 Q 37 -1 46 1
        ρ 50|M 9 -20 L 9 24 N O 26 24.5 17 25 0 360
        σ 54|N O 24 23 17 23 0 360 M 24 46 L 50 46
        χ 46|M 4 48 Q 14 52 19 34 L 29 -6 Q 33 -22 43 -18 M 41 49 L 6 -20
        Δ 60|M 4 0 L 30 70 L 56 0 L 4 0
        Σ 54|M 48 70 L 8 70 L 30 36 L 8 0 L 50 0
        """;

    private static readonly Dictionary<char, Glyph> Glyphs = Parse();
    private static readonly Glyph Missing = ParseGlyph("48|M 8 0 L 8 60 L 40 60 L 40 0 L 8 0");

    /// <summary>Strokes (lists of points) and advance width of a character, in font units.</summary>
    internal sealed record Glyph(float Width, Vector2[][] Strokes);

    /// <summary>The glyph of a character.</summary>
    public static Glyph Of(char character) => Glyphs.GetValueOrDefault(character, Missing);

    /// <summary>The width of a text in pixels at a height of capitals of 0.7 × size.</summary>
    public static float Measure(string text, float size)
    {
        float width = 0;
        foreach (char c in text)
            width += Of(c).Width;
        return width * size / 100;
    }

    private static Dictionary<char, Glyph> Parse()
    {
        var glyphs = new Dictionary<char, Glyph>();
        foreach (string line in Source.Split('\n'))
            glyphs[line[0]] = ParseGlyph(line[2..].TrimEnd('\r'));
        return glyphs;
    }

    private static Glyph ParseGlyph(string text)
    {
        int bar = text.IndexOf('|', StringComparison.Ordinal);
        var strokes = new List<Vector2[]>();
        var stroke = new List<Vector2>();
        string[] words = text[(bar + 1)..].Split(' ', StringSplitOptions.RemoveEmptyEntries);
        int at = 0;
        char command = ' ';
        while (at < words.Length)
        {
            if (char.IsLetter(words[at][0]))
                command = words[at++][0];
            if (command is 'M' or 'N')
                Finish();
            switch (command)
            {
                case 'M':
                    stroke.Add(Point());
                    break;
                case 'L':
                    stroke.Add(Point());
                    break;
                case 'Q':
                    AddCurve(stroke, Point(), Point());
                    break;
                case 'O':
                    AddArc(stroke, Point(), Point(), Number(), Number());
                    break;
            }
        }
        Finish();
        return new(float.Parse(text.AsSpan(0, bar), CultureInfo.InvariantCulture), [.. strokes]);

        float Number() => float.Parse(words[at++], CultureInfo.InvariantCulture);
        Vector2 Point() => new(Number(), Number());
        void Finish()
        {
            if (stroke.Count > 0)
                strokes.Add([.. stroke]);
            stroke.Clear();
        }
    }

    private static void AddCurve(List<Vector2> stroke, Vector2 control, Vector2 end)
    {
        Vector2 start = stroke[^1];
        for (int i = 1; i <= 8; i++)
        {
            float t = i / 8f;
            stroke.Add(start * ((1 - t) * (1 - t)) + control * (2 * t * (1 - t)) + end * (t * t));
        }
    }

    private static void AddArc(List<Vector2> stroke, Vector2 center, Vector2 radius, float from, float to)
    {
        int steps = Math.Max(4, (int)(Math.Abs(to - from) / 12));
        for (int i = 0; i <= steps; i++)
        {
            float angle = (from + (to - from) * i / steps) * (MathF.PI / 180);
            stroke.Add(center + radius * new Vector2(MathF.Cos(angle), MathF.Sin(angle)));
        }
    }
}
