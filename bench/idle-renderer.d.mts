/** As much of a renderer as wrinkles call before a mesh is drawn. */
export function idleRenderer(): { info: { calls: number } }
