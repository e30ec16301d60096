import type { Combine, GrayImage, LayerKind, WrinkleDriver } from 'furrow'
import type { AutoRegion, Stroke, StrokesDocument } from 'furrow/author'
import type { Furrows, ShapeCorrection } from 'furrow/internal'

/**
 * What an artist works on: the wrinkles of one face as plain data that never changes. An operation makes another document, in which
 * everything that it did not change is the same object: views compare by identity, and undo keeps old documents.
 */
export interface StudioDocument {
  /** Names of the mesh that wrinkles and of its material, as in `wrinkles.json`. */
  readonly mesh?: string
  readonly material?: string
  /** Millimetres per unit of the face's positions. */
  readonly scale: number
  /** Side in texels of the maps that are drawn from strokes. */
  readonly mapSize: number
  /** Side in texels of the areas. */
  readonly areaSize: number
  /** 1 to 4 with distinct names. */
  readonly layers: readonly StudioLayer[]
  /** With distinct names. */
  readonly areas: readonly StudioArea[]
  /** Layers with strokes have them drawn over their maps. */
  readonly strokes: readonly LayerStroke[]
  /** Shapes of areas that came with the strokes. */
  readonly strokeAreas?: StrokesDocument['areas']
  /** The net of fine furrows that came with the strokes: kept, and not drawn. */
  readonly furrows?: Furrows
  readonly drivers: readonly WrinkleDriver[]
  /** Corrections of what blendshapes were recognised as; absent where there are none. */
  readonly shapes?: readonly ShapeCorrection[]
  /** What the automatic wrinkles were made with; absent where there are none. */
  readonly auto?: AutoSettings
}

/** The maps of a layer that images can be. */
export const MAP_NAMES = ['normal', 'baseColor', 'roughness', 'occlusion', 'height', 'blood'] as const
export type MapName = (typeof MAP_NAMES)[number]

/** An encoded image, as it is in a file. */
export interface ImageFile {
  readonly mimeType: string
  readonly bytes: Uint8Array
}

export interface StudioLayer {
  readonly name: string
  readonly kind: LayerKind
  readonly maps: { readonly [Name in MapName]?: ImageFile }
  /** Factor on x and y of the normals. */
  readonly normalScale: number
  /** 0..1. */
  readonly occlusionStrength: number
  /** Metres from black to white of the height map. */
  readonly heightAmplitude?: number
  /** Optical depth of the blood map's white, 0..2. */
  readonly bloodAmplitude?: number
  /** Whether `autoWrinkles` made the blood map: it is made anew with the other automatic wrinkles. */
  readonly isBloodAutomatic?: boolean
}

/** Values of the fields of a new layer. */
export const LAYER_DEFAULTS = {
  kind: 'detail',
  maps: {},
  normalScale: 1,
  occlusionStrength: 1,
} as const satisfies Partial<StudioLayer>

export interface StudioArea {
  readonly name: string
  /** Name of its layer. */
  readonly layer: string
  readonly combine: Combine
  /** Activation at rest, 0..1. */
  readonly activation: number
  /** Of `areaSize`. */
  readonly weights: GrayImage
  /** Made by `autoWrinkles` and not painted since: made anew with the other automatic wrinkles. */
  readonly isAutomatic?: boolean
}

/** A stroke with the name of its layer. */
export type LayerStroke = Stroke & {
  readonly layer: string
  /** Made by `autoWrinkles` and not bent since. */
  readonly isAutomatic?: boolean
}

/** Ranges of these options, and the sizes that there are. */
export const AUTO_AGES = [20, 80] as const
export const AUTO_STRENGTHS = [0, 2] as const
export const AUTO_SIZES = [512, 1024, 2048, 4096] as const

/** Options of `autoWrinkles` that the studio offers. */
export interface AutoSettings {
  /** Years, 20..80. Where given, the face is so old at rest too. */
  readonly age?: number
  /** Multiplies the depth, 0..2. */
  readonly strength: number
  /** Side of the maps in texels. */
  readonly size: number
  readonly seed: number
  /** Of regions with lines of their own. */
  readonly seeds?: Readonly<Partial<Record<AutoRegion, number>>>
  /** All by default. */
  readonly regions?: readonly AutoRegion[]
  /** Corrections of blendshapes that they were made with. */
  readonly shapes?: readonly ShapeCorrection[]
}
