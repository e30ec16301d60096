import type { BareFace } from '../bare-faces/bare-faces.ts'

/** The bare faces; the file of number i is `/packed/bare-i.glb`. */
export const BARE_FACES: readonly BareFace[] = await (await fetch('/packed/bare-faces.json')).json()
