import { BufferViewWriter, type Glb, targetNamesOf } from 'furrow-files'
import { columnsOf } from '../capture/take-columns.ts'
import {
  durationOf,
  framesOf,
  TAKE_RATE,
  type Take,
  type TakeMotion,
  trimmed,
  weightsOf,
} from '../document/take.ts'

const FLOAT = 5126

/**
 * Adds takes to a file as animations of the weights of all its meshes with blendshapes. Writes only key frames between the in and out points.
 *
 * @param glb changed in place. Existing indices stay valid.
 */
export function addTakes(glb: Glb, takes: readonly Take[]): void {
  const { nodes = [], meshes = [] } = glb.json
  const moving = nodes.flatMap(({ mesh }, node) => {
    const targets = mesh === undefined || !meshes[mesh] ? [] : targetNamesOf(meshes[mesh])
    return targets.length > 0 ? [{ node, mesh: mesh!, targets }] : []
  })
  if (takes.length === 0 || moving.length === 0) return
  const views = new BufferViewWriter(glb)
  glb.json.accessors ??= []
  const { accessors } = glb.json
  const add = (values: Float32Array, limits: object) => {
    const bufferView = views.add(new Uint8Array(values.buffer, values.byteOffset, values.byteLength))
    const accessor = { bufferView, componentType: FLOAT, type: 'SCALAR', count: values.length, ...limits }
    return accessors.push(accessor) - 1
  }
  const animations = takes.map((take) => {
    const motion = trimmed(take)
    const times = Float32Array.from({ length: framesOf(motion) }, (_, i) => i / TAKE_RATE)
    const input = add(times, { min: [0], max: [Math.fround(durationOf(motion))] })
    // Nodes that show the same mesh share a sampler.
    const samplers = new Map<number, { index: number; output: number }>()
    const channels = moving.map(({ node, mesh, targets }) => {
      const known = samplers.get(mesh) ?? {
        index: samplers.size,
        output: add(allWeights(motion, targets), {}),
      }
      samplers.set(mesh, known)
      return { sampler: known.index, target: { node, path: 'weights' } }
    })
    return {
      name: take.name,
      samplers: [...samplers.values()].map(({ output }) => ({ input, output, interpolation: 'LINEAR' })),
      channels,
    }
  })
  views.finish()
  glb.json.animations = [...(glb.json.animations ?? []), ...animations]
}

/** Returns the weights of all blendshapes of a mesh, key frame by key frame. Blendshapes that the motion lacks are 0. */
function allWeights(motion: TakeMotion, targets: readonly string[]): Float32Array {
  const frames = framesOf(motion)
  const all = new Float32Array(frames * targets.length)
  for (const [target, column] of columnsOf(motion.names, targets)) {
    const weights = weightsOf(motion, column)
    for (let frame = 0; frame < frames; frame++) all[frame * targets.length + target] = weights[frame]
  }
  return all
}
