import type { BareFace } from '../bare-faces/bare-faces.ts'

/** Faces without wrinkles, listed by the test server. It serves number i as `/packed/bare-i.glb`. */
export const BARE_FACES: readonly BareFace[] = await (await fetch('/packed/bare-faces.json')).json()
