/** Creates a stub renderer with the members that wrinkles use before a mesh is drawn. */
export function idleRenderer(): { info: { calls: number } }
