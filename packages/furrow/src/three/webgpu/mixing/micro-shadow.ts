import { normalView, vec3 } from 'three/tsl'
import type { LightingModel, Node } from 'three/webgpu'
import { typed } from '../node.ts'
import { microShadow } from './mix-values.ts'

/**
 * Lets the layers' occlusion shadow the highlights of lights; those of the surroundings are by three.js.
 *
 * @param visibility occlusion of the layers over a value of 1.
 */
export function shadowHighlights<M extends LightingModel>(model: M, visibility: Node<'float'>): M {
  const { direct } = model
  const shadowAt = microShadow(visibility)
  model.direct = (input, builder) => {
    const { lightDirection, reflectedLight } = input
    const directSpecular = vec3(0).toVar()
    direct.call(model, { ...input, reflectedLight: { ...reflectedLight, directSpecular } }, builder)
    const shadow = shadowAt(normalView.dot(typed<'vec3'>(lightDirection)).clamp())
    typed<'vec3'>(reflectedLight.directSpecular).addAssign(directSpecular.mul(shadow))
  }
  return model
}
