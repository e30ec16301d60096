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
  /** JSON of unknown fields. */
  unknownFields: string
}

const CHANNELS = [TextureChannel.R, TextureChannel.G, TextureChannel.B, TextureChannel.A]

/** An area of influence of {@link MaterialWrinkles}: the location of one controllable group of wrinkles. */
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
      // Areas end at the edges of the image; repeating would blend in texels of the opposite edge.
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

  /** Returns the layer of the area; null for the first layer. */
  getLayer(): WrinkleLayer | null {
    return this.getRef('layer')
  }

  /** Sets the layer of the area; null for the first layer. */
  setLayer(layer: WrinkleLayer | null): this {
    return this.setRef('layer', layer)
  }

  /** Returns the image of the weights, linear, 1 = fully visible. Its slot is `weightsTexture`, which tools do not take for colours. */
  getTexture(): Texture | null {
    return this.getRef('weightsTexture')
  }

  /**
   * Sets the image of the weights.
   *
   * @param texture linear, 1 = fully visible; null removes it.
   * @param channel channel of the area, 0 = R to 3 = A; default: unchanged. Other areas may use the other channels.
   */
  setTexture(texture: Texture | null, channel = this.get('channel')): this {
    this.set('channel', channel)
    return this.setRef('weightsTexture', texture, { channels: CHANNELS[channel] })
  }

  /** Returns the channel of the area, 0 = R to 3 = A. */
  getChannel(): number {
    return this.get('channel')
  }

  /** Returns the slice of a KTX 2 array; null for an ordinary image. */
  getSlice(): number | null {
    const slice = this.get('slice')
    return slice === NO_SLICE ? null : slice
  }

  /** Sets the slice of a KTX 2 array; null for an ordinary image. */
  setSlice(slice: number | null): this {
    return this.set('slice', slice ?? NO_SLICE)
  }

  /** Returns texture coordinates and sampler; null without a texture. */
  getTextureInfo(): TextureInfo | null {
    return this.getRef('weightsTexture') ? this.getRef('weightsTextureInfo') : null
  }

  /** Returns how the area combines with others of its layer: `sum` or `max`. */
  getCombine(): Combine {
    return this.get('combine')
  }

  /** Sets how the area combines with others of its layer: `sum` or `max`. */
  setCombine(combine: Combine): this {
    return this.set('combine', combine)
  }

  /** Returns the resting activation, 0..1. */
  getActivation(): number {
    return this.get('activation')
  }

  /** Sets the resting activation, 0..1. */
  setActivation(activation: number): this {
    return this.set('activation', activation)
  }

  /** Returns unknown fields of the JSON, which are written back unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields by a copy. Fields must be plain JSON. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}
