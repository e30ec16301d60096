/** Maximum number of triangles after splitting. A mesh that has more is not split. */
export const MOST_TRIANGLES = 100_000
