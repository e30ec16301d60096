import {
  ExtensionProperty,
  type IProperty,
  type Nullable,
  type Texture,
  TextureChannel,
  TextureInfo,
} from '@gltf-transform/core'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import type { Combine } from '../core/types.ts'
import { NO_SLICE, type WrinkleLayer } from './wrinkle-layer.ts'

interface IWrinkleArea extends IProperty {
  layer: WrinkleLayer
  weightsTexture: Texture
  weightsTextureInfo: TextureInfo
  slice: number
  channel: number
  combine: Combine
  activation: number
  /** JSON text of unknown fields. */
  unknownFields: string
}

const CHANNELS = [TextureChannel.R, TextureChannel.G, TextureChannel.B, TextureChannel.A]

/** Area of influence: a gray image that tells where one controllable group of wrinkles is. See {@link MaterialWrinkles}. */
export class WrinkleArea extends ExtensionProperty<IWrinkleArea> {
  static override readonly EXTENSION_NAME = WRINKLE_MAPS
  declare readonly extensionName: typeof WRINKLE_MAPS
  declare readonly propertyType: 'WrinkleArea'
  declare readonly parentTypes: ['MaterialWrinkles']

  protected override init(): void {
    Object.assign(this, {
      extensionName: WRINKLE_MAPS,
      propertyType: 'WrinkleArea',
      parentTypes: ['MaterialWrinkles'],
    })
  }

  protected override getDefaults(): Nullable<IWrinkleArea> {
    return Object.assign(super.getDefaults() as IProperty, {
      layer: null,
      weightsTexture: null,
      // With `REPEAT`, filtering at an edge of the image would blend in texels of the opposite edge.
      weightsTextureInfo: new TextureInfo(this.graph, 'weightsTextureInfo')
        .setWrapS(TextureInfo.WrapMode.CLAMP_TO_EDGE)
        .setWrapT(TextureInfo.WrapMode.CLAMP_TO_EDGE),
      slice: NO_SLICE,
      channel: 0,
      combine: 'sum' as const,
      activation: 0,
      unknownFields: '{}',
    })
  }

  /** Returns the layer that the area controls. Null means the first layer. */
  getLayer(): WrinkleLayer | null {
    return this.getRef('layer')
  }

  /** Sets the layer that the area controls. Null means the first layer. */
  setLayer(layer: WrinkleLayer | null): this {
    return this.setRef('layer', layer)
  }

  /** Returns the image of the area's weights, in linear colour space. Wrinkles are fully visible where the weight is 1. */
  getTexture(): Texture | null {
    return this.getRef('weightsTexture')
  }

  /**
   * Sets the image of the area's weights.
   *
   * @param texture image in linear colour space, 1 = wrinkles fully visible. Null removes the image.
   * @param channel channel of the image that contains the weights, from 0 = R to 3 = A. By default, the channel does not change. Other areas
   *   may use the other channels of the image.
   */
  setTexture(texture: Texture | null, channel = this.get('channel')): this {
    this.set('channel', channel)
    return this.setRef('weightsTexture', texture, { channels: CHANNELS[channel] })
  }

  /** Returns the channel of the image that contains the weights, from 0 = R to 3 = A. */
  getChannel(): number {
    return this.get('channel')
  }

  /** Returns the slice of a KTX 2 texture array that contains the weights, or null if the image is not an array. */
  getSlice(): number | null {
    const slice = this.get('slice')
    return slice === NO_SLICE ? null : slice
  }

  /** Sets the slice of a KTX 2 texture array that contains the weights. Pass null if the image is not an array. */
  setSlice(slice: number | null): this {
    return this.set('slice', slice ?? NO_SLICE)
  }

  /** Returns the texture coordinate set and the sampler, or null if the area has no image. */
  getTextureInfo(): TextureInfo | null {
    return this.getRef('weightsTexture') ? this.getRef('weightsTextureInfo') : null
  }

  /** Returns how the area combines with overlapping areas of its layer: `sum` or `max`. */
  getCombine(): Combine {
    return this.get('combine')
  }

  /** Sets how the area combines with overlapping areas of its layer: `sum` or `max`. */
  setCombine(combine: Combine): this {
    return this.set('combine', combine)
  }

  /** Returns the activation of the area at rest, 0..1. */
  getActivation(): number {
    return this.get('activation')
  }

  /** Sets the activation of the area at rest, 0..1. */
  setActivation(activation: number): this {
    return this.set('activation', activation)
  }

  /** Returns the unknown fields of the area's JSON. Writing keeps them unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields by a copy of the given ones, which must be JSON data. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}
