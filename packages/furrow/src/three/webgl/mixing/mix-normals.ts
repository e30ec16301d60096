import type { LayerKind } from '../../../core/types.ts'

/** The layers' normals, as a program depends on them. */
export interface NormalLayers {
  kinds: readonly LayerKind[]
  /** Slice of each layer's normals. */
  normals: readonly (number | null)[]
}

/**
 * Declares `vec3 furrowMixNormals(vec3 base)`: `mixNormals` of the reference, of any length, since whoever uses it normalises it.
 * No function returns early: software rasterisers pay for that in every pixel.
 */
export function normalMixing({ kinds, normals }: NormalLayers): string {
  const influence = (layer: number) => `furrowInfluence[${layer}]`
  const sampled = kinds.map((kind, layer) => {
    const sample = `n${layer} = (furrowSampleSlice(furrowNormals, ${normals[layer]}.0).xyz * 2.0 - 1.0) * vec3(vec2(furrowNormalScale[${layer}]), 1.0);`
    return /* glsl */ `
    vec3 n${layer} = ${kind === 'replace' ? 'base' : 'vec3(0.0, 0.0, 1.0)'};
    ${kinds.length > 1 ? `if (${influence(layer)} > 0.0) ` : ''}${sample}`
  })
  const replacing = indicesOf(kinds, 'replace')
  const details = indicesOf(kinds, 'detail')
  const total = replacing.length > 1 ? ` / max(1.0, ${replacing.map(influence).join(' + ')})` : ''
  const replaced = replacing.map((layer) => ` + (n${layer} - base) * (${influence(layer)}${total})`)
  const slope = details.map((layer) => `n${layer}.xy * (${influence(layer)} / n${layer}.z)`).join(' + ')
  const reoriented = `
    normal = furrowReorient(normal, vec3(${slope}, 1.0));`
  return /* glsl */ `
uniform highp sampler2DArray furrowNormals;
uniform vec4 furrowNormalScale;
${details.length > 0 ? REORIENT : ''}
vec3 furrowMixNormals(vec3 base) {
  vec3 normal = base;
  if (furrowHasInfluence) {${sampled.join('')}
    normal = base${replaced.join('')};${details.length > 0 ? reoriented : ''}
  }
  return normal;
}
`
}

/**
 * Reoriented normal mapping, see `reorientNormal` in the reference: the same direction, from vectors of any length. Of t and r there, the
 * base's length times t.z is left in as a factor, so that nothing is divided.
 */
const REORIENT = /* glsl */ `
vec3 furrowReorient(vec3 base, vec3 detail) {
  float size = length(base);
  vec3 t = vec3(base.xy, base.z + size);
  vec3 r = vec3(-detail.xy, detail.z);
  return t * dot(t, r) - r * (size * t.z);
}
`

function indicesOf(kinds: readonly LayerKind[], kind: LayerKind): number[] {
  return kinds.flatMap((own, layer) => (own === kind ? [layer] : []))
}
