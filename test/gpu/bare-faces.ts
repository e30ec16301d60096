import type { BareFace } from '../bare-faces/bare-faces.ts'

/** Bare faces. Number i is served as `/packed/bare-i.glb`. */
export const BARE_FACES: readonly BareFace[] = await (await fetch('/packed/bare-faces.json')).json()
