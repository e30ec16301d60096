import type { Combine, GrayImage, LayerKind, WrinkleDriver } from 'furrow'
import type { AutoRegion, Stroke, StrokesDocument } from 'furrow/author'
import type { Furrows, ShapeCorrection } from 'furrow/internal'

/**
 * The wrinkles of one face, as immutable plain data. Operations return a new document that shares every unchanged object: views
 * compare by identity, and undo keeps old documents.
 */
export interface StudioDocument {
  /** Names of the mesh and its material, as in `wrinkles.json`. */
  readonly mesh?: string
  readonly material?: string
  /** Millimetres per unit of the face's positions. */
  readonly scale: number
  /** Side of the maps drawn from strokes, texels. */
  readonly mapSize: number
  /** Side of the areas, texels. */
  readonly areaSize: number
  /** 1 to 4 layers with unique names. */
  readonly layers: readonly StudioLayer[]
  /** Areas with unique names. */
  readonly areas: readonly StudioArea[]
  /** Strokes are drawn over the maps of their layer. */
  readonly strokes: readonly LayerStroke[]
  /** Area shapes imported with the strokes. */
  readonly strokeAreas?: StrokesDocument['areas']
  /** Net of fine furrows imported with the strokes: kept, but not drawn. */
  readonly furrows?: Furrows
  readonly drivers: readonly WrinkleDriver[]
  /** Corrections of recognised blendshapes. Absent if there are none. */
  readonly shapes?: readonly ShapeCorrection[]
  /** Settings of the automatic wrinkles. Absent if there are none. */
  readonly auto?: AutoSettings
}

/** Layer maps that can be images. */
export const MAP_NAMES = ['normal', 'baseColor', 'roughness', 'occlusion', 'height', 'blood'] as const
export type MapName = (typeof MAP_NAMES)[number]

/** Encoded image, as stored in a file. */
export interface ImageFile {
  readonly mimeType: string
  readonly bytes: Uint8Array
}

export interface StudioLayer {
  readonly name: string
  readonly kind: LayerKind
  readonly maps: { readonly [Name in MapName]?: ImageFile }
  /** Factor for x and y of the normals. */
  readonly normalScale: number
  /** Occlusion strength, 0..1. */
  readonly occlusionStrength: number
  /** Height range from black to white, metres. */
  readonly heightAmplitude?: number
  /** Optical depth at white in the blood map, 0..2. */
  readonly bloodAmplitude?: number
  /** Whether `autoWrinkles` made the blood map. It is then replaced with the other automatic wrinkles. */
  readonly isBloodAutomatic?: boolean
}

/** Defaults of a new layer. */
export const LAYER_DEFAULTS = {
  kind: 'detail',
  maps: {},
  normalScale: 1,
  occlusionStrength: 1,
} as const satisfies Partial<StudioLayer>

export interface StudioArea {
  readonly name: string
  /** Layer name. */
  readonly layer: string
  readonly combine: Combine
  /** Activation at rest, 0..1. */
  readonly activation: number
  /** Weights, `areaSize` texels square. */
  readonly weights: GrayImage
  /** Made by `autoWrinkles` and not painted since. It is then replaced with the other automatic wrinkles. */
  readonly isAutomatic?: boolean
}

/** Stroke with the name of its layer. */
export type LayerStroke = Stroke & {
  readonly layer: string
  /** Made by `autoWrinkles` and not edited since. */
  readonly isAutomatic?: boolean
}

/** Ranges of `age` and `strength`, and the available sizes. */
export const AUTO_AGES = [20, 80] as const
export const AUTO_STRENGTHS = [0, 2] as const
export const AUTO_SIZES = [512, 1024, 2048, 4096] as const

/** Options of `autoWrinkles` offered by the studio. */
export interface AutoSettings {
  /** Age in years, 20..80. If set, also ages the neutral face. */
  readonly age?: number
  /** Depth factor, 0..2. */
  readonly strength: number
  /** Side of the maps, texels. */
  readonly size: number
  readonly seed: number
  /** Seeds that override `seed` per region. */
  readonly seeds?: Readonly<Partial<Record<AutoRegion, number>>>
  /** Default: all regions. */
  readonly regions?: readonly AutoRegion[]
  /** Blendshape corrections used for the automatic wrinkles. */
  readonly shapes?: readonly ShapeCorrection[]
}
