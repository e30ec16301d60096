import { mix, normalMap, texture, vec3, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { BLOOD, type StrippedPatch } from './stripped.ts'

/** For `WebGPURenderer`. */
export const strippedPatch: StrippedPatch = (material, maps) => {
  const influence = texture(maps.strippedInfluence).r.toVar()
  const surface = texture(maps.strippedSurface).toVar()
  const wrinkle = texture(maps.strippedNormals).xyz.mul(2).sub(1).toVar()
  const lifted = texture(material.normalMap!)
    .xyz.mul(2)
    .sub(vec3(1, 1, 0))
    .toVar()
  const turned = vec3(wrinkle.xy.mul(influence.negate().div(wrinkle.z)), 1).toVar()
  const normal = lifted.mul(lifted.dot(turned)).div(lifted.z).sub(turned)
  const blood = influence.mul(surface.b.mul(255).sub(128)).div(127)
  const [red, green, blue] = BLOOD
  const own = texture(material.map!)
  const flushed = own.rgb.mul(
    blood
      .negate()
      .mul(vec3(red, green, blue))
      .exp(),
  )
  // Plain materials carry nodes too: the renderer copies them to the nodes that it makes of these.
  Object.assign(material, {
    normalNode: normalMap(normal.mul(0.5).add(0.5) as Node<'vec3'>),
    colorNode: vec4(flushed, own.a),
    aoNode: mix(texture(material.aoMap!).r, surface.r, influence),
    customProgramCacheKey: () => 'stripped',
  })
}
