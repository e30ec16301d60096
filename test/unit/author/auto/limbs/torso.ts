import type { Skin } from 'furrow/author'
import { RIGS, type SkeletonOptions, skeletonOf } from './rigs.ts'
import { skinOf, tube } from './tube.ts'

const [AROUND, ALONG] = [48, 40]
const [LOW, HIGH] = [0.98, 1.36]

/**
 * Returns a shirt without sleeves around the trunk of a person, in metres. Its texture is the unrolled shirt: u runs from the back over the
 * person's left, the front and the right, and v from the hem upwards.
 */
export function torso(options: SkeletonOptions = {}): Skin {
  const { joints } = skeletonOf(RIGS.Mixamo!, options)
  const { scale = 1 } = options
  const shirt = tube(AROUND, ALONG, (s, t) => {
    const y = LOW + s * (HIGH - LOW)
    const angle = 2 * Math.PI * t
    return {
      position: [0.165 * scale * Math.sin(angle), scale * y, -0.115 * scale * Math.cos(angle)],
      uv: [0.02 + 0.96 * t, 0.02 + 0.96 * s],
      shares: trunkShares(y),
    }
  })
  return skinOf([shirt], joints)
}

/** Returns how much hips, spine and chest move a trunk at a height in metres. Each joint takes over around its position. */
export function trunkShares(y: number): [joint: number, weight: number][] {
  const [low, high] = [1.1, 1.25].map((at) => Math.min(1, Math.max(0, (y - at) / 0.1 + 0.5))) as [
    number,
    number,
  ]
  return [
    [0, 1 - low],
    [1, low - high],
    [2, high],
  ]
}
