import { normalView, vec3 } from 'three/tsl'
import type { LightingModel, Node } from 'three/webgpu'
import { typed } from '../node.ts'
import { microShadow } from './mix-values.ts'

/**
 * Edits a lighting model so that the occlusion of layers darkens specular highlights of lights. three.js itself darkens only reflections of
 * environment maps.
 *
 * @param visibility occlusion of layers, 0 (occluded) to 1.
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
