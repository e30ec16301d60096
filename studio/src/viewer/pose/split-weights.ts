import { AnimationClip, type KeyframeTrack, NumberKeyframeTrack } from 'three'

/**
 * Splits each track that contains the weights of all blendshapes into one track per blendshape. Muscles add blendshapes to a mesh, so a track for all
 * blendshapes would have too few values.
 */
export function splitWeights({ name, duration, tracks }: AnimationClip): AnimationClip {
  return new AnimationClip(
    name,
    duration,
    tracks.flatMap((track) => (/\.morphTargetInfluences$/.test(track.name) ? splitTrack(track) : track)),
  )
}

/** Property by which GLTFLoader marks cubic interpolation. The type definitions lack it. */
interface Interpolated {
  createInterpolant: { isInterpolantFactoryMethodGLTFCubicSpline?: true }
}

function splitTrack(track: KeyframeTrack): KeyframeTrack[] {
  const { createInterpolant } = track as unknown as Interpolated
  const isCubic = createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline
  // A cubic key frame contains all in-tangents, then all values, then all out-tangents.
  const count = track.getValueSize() / (isCubic ? 3 : 1)
  return Array.from({ length: count }, (_, target) => {
    const values = track.values.filter((_, i) => i % count === target)
    const part = new NumberKeyframeTrack(`${track.name}[${target}]`, track.times, values)
    if (isCubic) Object.assign(part, { createInterpolant })
    else part.setInterpolation(track.getInterpolation())
    return part
  })
}
