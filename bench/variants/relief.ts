import type { GrayImage } from 'furrow'
import { applyFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

const SIDE = 512

/** Bands of some millimetres over the whole texture: relief costs the same whatever its heights are. */
const bands: GrayImage = {
  width: SIDE,
  height: SIDE,
  data: Uint8Array.from({ length: SIDE * SIDE }, (_, i) =>
    Math.round(127.5 + 100 * Math.sin(Math.floor(i / SIDE) / 2)),
  ),
}

/** Furrow's default mode with relief: heights move the surface of a dense geometry. */
export const variant: Variant = {
  canShow: ({ areas, layers }) => areas === 8 && layers === 1,
  apply: (mesh, { areas, layers }, renderer) => {
    const raised = layers.map((layer) => ({ ...layer, height: bands, heightAmplitude: 0.001 }))
    const wrinkles = applyFurrow(mesh, { areas, layers: raised }, renderer, { relief: 'on' })
    return Object.assign(wrinkles, { ready: wrinkles.reliefReady() })
  },
}
