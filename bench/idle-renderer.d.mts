/** A stub with what wrinkles call of a renderer before a mesh is drawn. */
export function idleRenderer(): { info: { calls: number } }
