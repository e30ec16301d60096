import { Color, type IUniform } from 'three'
import type { ShowInfluence } from '../../material/influence-view.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { areaUniforms, influenceFromAreas } from '../influence/influence-from-areas.ts'
import { instancedVertex } from '../mixing/default-shader.ts'
import { MAIN, replace, replaceChunk } from '../patch/shader-text.ts'
import { mapUniforms } from '../uniforms.ts'

/**
 * Patches an unlit material to show the influence map of a face in gray, or the weights of areas if a table of activations is given. Black =
 * no wrinkles, white = fully visible.
 */
export const showInfluence: ShowInfluence = (
  material,
  { wrinkled: { normalMap }, inputs, instances },
  table,
) => {
  const layers = inputs.textures.layers.length
  const { channels } = inputs.areas
  const uniforms: Record<string, IUniform> = table ? areaUniforms(inputs, table) : mapUniforms(inputs)
  // The shader does not sample `map`, but uses its texture coordinates and transform.
  Object.assign(material, { map: normalMap, color: new Color(1, 1, 1), needsUpdate: true })
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms)
    if (!table && instances) shader.vertexShader = instancedVertex(shader.vertexShader, instances)
    shader.fragmentShader = table
      ? areasFragment(shader.fragmentShader, channels)
      : mapFragment(shader.fragmentShader, layers, instances !== null)
  }
  const variant = table ? `areas ${channels}` : `map ${layers} ${instances}`
  material.customProgramCacheKey = () => `furrow influence ${variant}`
}

const SHOW_LARGEST =
  'diffuseColor.rgb *= vec3(max(max(influence.x, influence.y), max(influence.z, influence.w)));'

/** Patches an unlit fragment shader to sample the influence map, and to show the largest influence of any layer. */
function mapFragment(fragment: string, layers: number, isInstanced: boolean): string {
  const declarations = influenceFromMap(layers, isInstanced ? 'instances' : 'mesh', true)
  const started = replace(fragment, MAIN, `${declarations}\n${MAIN}\n\tfurrowSampleInfluence(vMapUv);`)
  return replaceChunk(started, 'map_fragment', () => `vec4 influence = furrowInfluence;\n\t${SHOW_LARGEST}`)
}

/** Patches an unlit fragment shader to compute the influence in a loop over all areas, and to show the largest influence of any layer. */
function areasFragment(fragment: string, channels: 1 | 4): string {
  const declared = replace(fragment, MAIN, `${influenceFromAreas(channels)}\n${MAIN}`)
  const influence = 'vec4 influence = furrowInfluenceFromAreas(vMapUv);'
  return replaceChunk(declared, 'map_fragment', () => `${influence}\n\t${SHOW_LARGEST}`)
}
