import { normalView, vec3 } from 'three/tsl'
import type { LightingModel, Node } from 'three/webgpu'
import { typed } from '../node.ts'
import { microShadow } from './mix-values.ts'

/**
 * Shadows the specular highlights of lights by the layers' occlusion. three.js does so for environment maps.
 *
 * @param visibility the layers' occlusion alone.
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
