/** Default maximum number of triangles after subdivision. A mesh that has more triangles before subdivision is not subdivided. */
export const MAX_TRIANGLES = 100_000
