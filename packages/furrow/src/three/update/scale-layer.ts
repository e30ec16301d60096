import { checkFinite, isObject, wrongArgument } from '../../core/argument.ts'
import type { Layer } from '../../core/types.ts'
import { checkBloodAmplitude } from '../../core/wrinkle-set.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { unknownLayer } from './unknown-layer.ts'

const WHO = 'scaleLayer'

/** Strengths of a layer; see `Layer`. */
export type LayerScale = Pick<Layer, 'normalScale' | 'occlusionStrength' | 'bloodAmplitude'>

/**
 * Sets the strengths of a layer from the next frame on, on these wrinkles and all others that share their textures. Nothing is compiled or
 * uploaded, but the modes `paper` and `composed` redraw their maps.
 *
 * @param wrinkles wrinkles of the face.
 * @param name name of the layer.
 * @param scale new strengths; omitted ones stay unchanged.
 * @throws FurrowError if the layer is unknown, a number is out of range, or the wrinkles were disposed of; nothing then changes.
 */
export function scaleLayer(wrinkles: WrinklesBase, name: string, scale: LayerScale): void {
  checkWrinkles(wrinkles, WHO)
  const mesh = meshOf(wrinkles)
  mesh.checkInUse(WHO)
  const { textures } = mesh.shaderInputs
  const index = textures.layers.findIndex((layer) => layer.name === name)
  if (index < 0) throw unknownLayer(name, textures.layers, WHO)
  if (!isObject(scale))
    throw wrongArgument(WHO, 'scale', scale, 'normalScale, occlusionStrength, bloodAmplitude')
  const layer = textures.layers[index]
  const {
    normalScale = layer.normalScale ?? 1,
    occlusionStrength = layer.occlusionStrength ?? 1,
    bloodAmplitude = layer.bloodAmplitude ?? 0,
  } = scale
  checkFinite(normalScale, `normalScale of layer "${name}"`, WHO)
  checkFinite(occlusionStrength, `occlusionStrength of layer "${name}"`, WHO)
  checkBloodAmplitude(bloodAmplitude, name, WHO)
  textures.layers[index] = { ...layer, normalScale, occlusionStrength, bloodAmplitude }
  textures.normalScale.value.setComponent(index, normalScale)
  textures.occlusionStrength.value.setComponent(index, occlusionStrength)
  textures.bloodAmplitude.value.setComponent(index, bloodAmplitude)
  textures.version++
}
