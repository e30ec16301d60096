/** Creates a stub renderer with the members that `Wrinkles` uses before three.js draws its mesh. */
export function idleRenderer(): { info: { calls: number } }
