namespace MeshLab.Subdivision;

/// <summary>Why subdivision ended.</summary>
public enum SubdivisionStop
{
    /// <summary>All steps asked for were done.</summary>
    StepsDone,

    /// <summary>The mesh has no faces, or neither a step nor the limit was asked for.</summary>
    NothingToDo,
}

/// <summary>What subdivision did.</summary>
/// <param name="StopReason">Why it ended.</param>
/// <param name="Steps">Steps done.</param>
/// <param name="FacesBefore">Faces of the input.</param>
/// <param name="FacesAfter">Faces of the result.</param>
public sealed record SubdivisionReport(SubdivisionStop StopReason, int Steps, int FacesBefore, int FacesAfter);
