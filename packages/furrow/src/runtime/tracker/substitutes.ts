/** Raises the weight of a shape. Weights and the highest weights that the source delivered so far are indexed by shape. */
type Apply = (weights: Float64Array, reach: Float64Array) => void

/**
 * Estimates a blendshape from two others, for sources that hardly deliver it. MediaPipe scores `noseSneer` and `cheekSquint` near 0
 * (https://github.com/google-ai-edge/mediapipe/issues/4450).
 */
export interface Substitute {
  readonly shape: string
  readonly from: readonly [string, string]
  /** Creates the function that raises the shape, from the indices of the shape and of the two others. */
  readonly create: (shape: number, a: number, b: number) => Apply
}

/** Weight from which on a shape counts as delivered, so that its estimate has no effect. */
const DELIVERED = 0.3

/** A sneer raises the upper lip and lowers the brows (AU 9 of FACS). Both must move, because speech also raises the lip. */
function sneer(shape: number, lip: number, brow: number): Apply {
  return (weights, reach) => {
    const estimate = Math.min(1, 1.6 * Math.sqrt(weights[lip] * weights[brow]))
    weights[shape] = Math.max(weights[shape], estimate * (1 - Math.min(1, reach[shape] / DELIVERED)))
  }
}

/** The ring muscle of the eye raises the cheek when the eye squints, and more so in a smile (AU 6 of FACS). */
function cheek(shape: number, smile: number, squint: number): Apply {
  return (weights, reach) => {
    const estimate = Math.min(1, 0.4 * weights[smile] + 0.6 * weights[squint])
    weights[shape] = Math.max(weights[shape], estimate * (1 - Math.min(1, reach[shape] / DELIVERED)))
  }
}

export const SUBSTITUTES: readonly Substitute[] = [
  { shape: 'noseSneerLeft', from: ['mouthUpperUpLeft', 'browDownLeft'], create: sneer },
  { shape: 'noseSneerRight', from: ['mouthUpperUpRight', 'browDownRight'], create: sneer },
  { shape: 'cheekSquintLeft', from: ['mouthSmileLeft', 'eyeSquintLeft'], create: cheek },
  { shape: 'cheekSquintRight', from: ['mouthSmileRight', 'eyeSquintRight'], create: cheek },
]
