/** Default maximum number of triangles after subdivision. A mesh with more triangles is not subdivided. */
export const MAX_TRIANGLES = 100_000
