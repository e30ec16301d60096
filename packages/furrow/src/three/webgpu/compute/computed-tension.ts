import { type BindTension, indexIn, sampledTension, tensionSurface } from '../../sources/tension.ts'
import { AreaTension } from './area-tension.ts'
import { canCompute } from './buffers.ts'

/**
 * Creates a reader of tension inputs, which measures how much the skin under areas is compressed or stretched. Compute passes measure all
 * triangles under an area. Until the first result, and without compute support, the CPU measures a sample of the triangles.
 */
export const bindComputedTension: BindTension = (face, inputs) => {
  const surface = tensionSurface(face, inputs)
  const sampled = sampledTension(face.mesh, surface, inputs)
  if (inputs.length === 0) return sampled
  const tension = new AreaTension(face.mesh, surface)
  face.onRelease?.(() => tension.release())
  const indices = inputs.map(
    (input) => 2 * indexIn(surface.measured, input) + (input.measure === 'stretch' ? 1 : 0),
  )
  return {
    ...sampled,
    read(values, instance, renderer) {
      if (renderer && canCompute(renderer)) tension.update(renderer)
      if (tension.isReady) tension.copyTo(values, indices)
      else sampled.read(values, instance, renderer)
    },
  }
}
