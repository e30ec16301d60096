import { SMALLEST_ONSET_RANGE } from '../../../core/limits.ts'
import { texelOf, type ValueLayers } from '../../../runtime/maps/value-texels.ts'
import type { Values } from './value-layers.ts'

/** Declares `float furrowOnsetInfluence(float influence, float onset, float strength)`, see `onsetInfluence` in the reference. */
export const ONSET_INFLUENCE = /* glsl */ `
uniform vec4 furrowOnsetStrength;

float furrowOnsetInfluence(float influence, float onset, float strength) {
  float t = clamp(1.0 - (1.0 - influence) / max(1.0 - onset, ${SMALLEST_ONSET_RANGE}), 0.0, 1.0);
  return influence + (t * (2.0 - t) - influence) * strength;
}
`

/**
 * Declares `void furrowApplyOnset()`, which delays `furrowInfluence` by the onset maps. A texel of an onset map is the influence at which
 * wrinkles begin to show at this texel. Shaders must call `furrowReadValues` first. Layers without an onset map keep their influence.
 */
export function onsetApplication({ slices, channel, sampler }: ValueLayers): string {
  const statements = slices.flatMap((slice, layer) => {
    if (slice === null) return []
    const onset = `${texelOf(sampler, slice)}[${channel}]`
    const influence = `furrowInfluence[${layer}]`
    return `${influence} = furrowOnsetInfluence(${influence}, ${onset}, furrowOnsetStrength[${layer}]);`
  })
  return /* glsl */ `${ONSET_INFLUENCE}
void furrowApplyOnset() {
  ${statements.join('\n  ')}
}
`
}

/** Returns only the onset maps of the layers, for shaders that mix no other value maps. */
export function onsetOf({ onset }: Values): Values {
  return onset ? { onset } : {}
}
