import { type InstancedMesh, type Mesh, REVISION } from 'three'
import { FurrowError } from '../../core/error.ts'
import { MAX_TRIANGLES } from '../../relief/max-triangles.ts'
import { instancesOf } from '../mesh/instances.ts'
import { releaseOf } from '../three-version.ts'

/** Oldest three.js release whose `RenderTarget` supports several textures, which relief needs. */
const OLDEST_THREE_WITH_RELIEF = 162

/** Returns the reason why relief, i.e. displacement by height maps, is unsupported for a mesh; null if it is supported. */
export function limitationOf(mesh: Mesh): FurrowError | null {
  const { index, attributes } = mesh.geometry
  const count = Math.floor((index ?? attributes.position).count / 3)
  const who = `Wrinkles.relief of mesh "${mesh.name}"`
  if (count > MAX_TRIANGLES) {
    return new FurrowError({
      code: 'out-of-range',
      who,
      problem: 'too many triangles to split',
      value: count,
      limit: `${MAX_TRIANGLES} triangles`,
      remedy: 'simplify the mesh, and bake fine detail to its normal map',
    })
  }
  if (releaseOf(REVISION) < OLDEST_THREE_WITH_RELIEF) {
    return new FurrowError({
      code: 'unsupported',
      who,
      problem: 'three.js is too old for relief',
      value: `r${REVISION}`,
      limit: `r${OLDEST_THREE_WITH_RELIEF} or later`,
      remedy: "install a later release of three.js, or set relief to 'off'",
    })
  }
  const { morphTexture } = mesh as Partial<InstancedMesh>
  if (instancesOf(mesh) !== 'batched' && !morphTexture) return null
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: morphTexture
      ? 'unsupported instances with their own blendshape weights'
      : 'unsupported BatchedMesh',
    limit: 'meshes, and instances that share blendshape weights',
    remedy: "set relief to 'off'",
  })
}
