/** Triangles that a mesh has at most after splitting; one that begins with more is not split at all. */
export const MOST_TRIANGLES = 100_000
