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

/** An area of influence of {@link MaterialWrinkles}: where one controllable group of wrinkles is. */
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
      // Areas end at the edges of their image; repeating would filter texels of the opposite edge in.
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

  /** The layer whose wrinkles it shows; null for the first. */
  getLayer(): WrinkleLayer | null {
    return this.getRef('layer')
  }

  /** Sets the layer whose wrinkles it shows; null for the first. */
  setLayer(layer: WrinkleLayer | null): this {
    return this.setRef('layer', layer)
  }

  /** The image of the weights, linear, 1 = fully visible; its slot is `weightsTexture`, which no tool takes for colour. */
  getTexture(): Texture | null {
    return this.getRef('weightsTexture')
  }

  /**
   * Sets the image of the weights.
   *
   * @param texture linear, 1 = fully visible; null for none.
   * @param channel the one that holds this area, 0 = R to 3 = A; unchanged by default. Other areas may use the others.
   */
  setTexture(texture: Texture | null, channel = this.get('channel')): this {
    this.set('channel', channel)
    return this.setRef('weightsTexture', texture, { channels: CHANNELS[channel] })
  }

  /** The channel of the texture that holds this area, 0 = R to 3 = A. */
  getChannel(): number {
    return this.get('channel')
  }

  /** Slice of its texture if that is a KTX 2 array; null if it is an ordinary image. */
  getSlice(): number | null {
    const slice = this.get('slice')
    return slice === NO_SLICE ? null : slice
  }

  /** Sets the slice of its texture if that is a KTX 2 array; null for an ordinary image. */
  setSlice(slice: number | null): this {
    return this.set('slice', slice ?? NO_SLICE)
  }

  /** Texture coordinates and sampler; null while it has no texture. */
  getTextureInfo(): TextureInfo | null {
    return this.getRef('weightsTexture') ? this.getRef('weightsTextureInfo') : null
  }

  /** How it combines with other areas of its layer: `sum` or `max`. */
  getCombine(): Combine {
    return this.get('combine')
  }

  /** Sets how it combines with other areas of its layer: `sum` or `max`. */
  setCombine(combine: Combine): this {
    return this.set('combine', combine)
  }

  /** Activation at rest, 0..1. */
  getActivation(): number {
    return this.get('activation')
  }

  /** Sets the activation at rest, 0..1. */
  setActivation(activation: number): this {
    return this.set('activation', activation)
  }

  /** Fields of the JSON that are unknown to this version; they are written back unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields with a copy of these, which must be plain JSON. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}
