/** Default maximum number of triangles after subdivision. A mesh with more triangles is not subdivided. */
export const MOST_TRIANGLES = 100_000
