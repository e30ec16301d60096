import { type InstancedMesh, type Mesh, REVISION } from 'three'
import { FurrowError } from '../../core/error.ts'
import { MOST_TRIANGLES } from '../../relief/most-triangles.ts'
import { instancesOf } from '../mesh/instances.ts'
import { releaseOf } from '../three-version.ts'

/** The oldest release of three.js that draws into several textures of one `RenderTarget`. */
const OLDEST_THREE_WITH_RELIEF = 162

/** Why a mesh with which nothing is wrong has no relief; null if it can have it. */
export function limitationOf(mesh: Mesh): FurrowError | null {
  const { index, attributes } = mesh.geometry
  const count = Math.floor((index ?? attributes.position).count / 3)
  const who = `Wrinkles.relief of mesh "${mesh.name}"`
  if (count > MOST_TRIANGLES) {
    return new FurrowError({
      code: 'out-of-range',
      who,
      problem: 'the mesh has too many triangles to split',
      value: count,
      limit: `${MOST_TRIANGLES} triangles`,
      remedy: 'reduce it; fine detail belongs into its normal map',
    })
  }
  if (releaseOf(REVISION) < OLDEST_THREE_WITH_RELIEF) {
    return new FurrowError({
      code: 'unsupported',
      who,
      problem: 'three.js is too old for relief',
      value: `r${REVISION}`,
      limit: `r${OLDEST_THREE_WITH_RELIEF} or later`,
      remedy: 'install a later release of three.js, or show it without relief',
    })
  }
  const { morphTexture } = mesh as Partial<InstancedMesh>
  if (instancesOf(mesh) !== 'batched' && !morphTexture) return null
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: morphTexture ? 'instances with blendshapes of their own' : 'a BatchedMesh',
    limit: 'meshes, and instances that move as one',
    remedy: 'show it without relief',
  })
}
