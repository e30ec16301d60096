import type { Combine, GrayImage, LayerKind, WrinkleDriver } from 'furrow'
import type { AutoRegion, AutoSide, ClothKind, DenseRegion, Stroke, StrokesDocument } from 'furrow/author'
import type { Furrows, ShapeCorrection, SurfaceKind } from 'furrow/internal'
import type { Sculpted } from './sculpted.ts'
import type { Take } from './take.ts'

/**
 * Wrinkles of one face, as immutable data. Operations return a new document that shares all unchanged objects with the old one. Views
 * therefore find changes by comparing identities, and undo can keep old documents.
 */
export interface StudioDocument {
  /** Names of the mesh and its material, as in `wrinkles.json`. */
  readonly mesh?: string
  readonly material?: string
  /** Millimetres per unit of the face's positions. */
  readonly scale: number
  /** Width and height of the maps drawn from strokes, texels. */
  readonly mapSize: number
  /** Width and height of the areas' weights, texels. */
  readonly areaSize: number
  /** 1 to 4 layers with unique names. */
  readonly layers: readonly StudioLayer[]
  /** Areas of influence with unique names. */
  readonly areas: readonly StudioArea[]
  /** Wrinkles as curves, which are drawn over the images of their layer. */
  readonly strokes: readonly LayerStroke[]
  /** Shapes of areas from an imported `strokes.json`. */
  readonly strokeAreas?: StrokesDocument['areas']
  /** Settings of a net of fine furrows from an imported `strokes.json`. The studio stores them but does not draw the net. */
  readonly furrows?: Furrows
  readonly drivers: readonly WrinkleDriver[]
  /** The artist's corrections of blendshapes whose meaning was recognised wrongly. Absent if there are none. */
  readonly shapes?: readonly ShapeCorrection[]
  readonly auto?: AutoSettings
  /** Recorded performances with unique names. Absent if there are none. */
  readonly takes?: readonly Take[]
}

/** Kinds of maps that a layer can have as images. */
export const MAP_NAMES = [
  'normal',
  'baseColor',
  'roughness',
  'occlusion',
  'height',
  'blood',
  'onset',
] as const
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
  /** Strength of the onset map, 0..1; default 1. */
  readonly onsetStrength?: number
  /** Whether `autoWrinkles` made the blood map. If so, the next automatic wrinkles replace it. */
  readonly isBloodAutomatic?: boolean
  /** Whether the onset map is drawn from the layer's strokes. If so, `maps` has no onset map. */
  readonly isOnsetDrawn?: boolean
  /** Heights that brushes have sculpted. They are added to the heights of the layer's strokes. */
  readonly sculpted?: Sculpted
}

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
  /** Weights, an image of `areaSize` x `areaSize` texels. */
  readonly weights: GrayImage
  /** Whether the area is as `autoWrinkles` made it. If so, the next automatic wrinkles replace it. */
  readonly isAutomatic?: boolean
}

/** Stroke with the name of its layer. */
export type LayerStroke = Stroke & {
  readonly layer: string
  /** Whether the stroke is as `autoWrinkles` made it. */
  readonly isAutomatic?: boolean
}

/** Ranges of `age`, `strength`, `symmetry` and `densities` in `AutoSettings`, and the choices for `size`. */
export const AUTO_AGES = [20, 80] as const
export const AUTO_STRENGTHS = [0, 2] as const
export const AUTO_SYMMETRIES = [0, 1] as const
export const AUTO_DENSITIES = [0.5, 2] as const
export const AUTO_SIZES = [512, 1024, 2048, 4096] as const

/** Settings of automatic wrinkles: options of `autoWrinkles` that the studio offers, and the kind of the surface. */
export interface AutoSettings {
  /** Age in years, 20..80. If set, the face also has wrinkles at rest. */
  readonly age?: number
  /** Factor on the depth of wrinkles, 0..2. */
  readonly strength: number
  /** Width and height of the maps, texels. */
  readonly size: number
  /** Random seed. Default: derived from the proportions of the face. */
  readonly seed?: number
  /** Seeds of single regions, which override `seed`. */
  readonly seeds?: Readonly<Partial<Record<AutoRegion, number>>>
  /** Factors on the depth in regions, or in halves of regions. Values over 2 are possible, but new automatic wrinkles get at most 2. */
  readonly strengths?: Readonly<Partial<Record<AutoSide, number>>>
  /** Factors on the number of lines in regions, 0.5..2. */
  readonly densities?: Readonly<Partial<Record<DenseRegion, number>>>
  /** How much the right side mirrors the left side, 0..1. Default: 0. */
  readonly symmetry?: number
  /** Regions of the face that get wrinkles. Default: all regions. */
  readonly regions?: readonly AutoRegion[]
  /** `StudioDocument.shapes` at the time when the automatic wrinkles were made. */
  readonly shapes?: readonly ShapeCorrection[]
  /** Kind of the surface, as the user stated. Default: judged by names and material. */
  readonly kind?: SurfaceKind
  /** Kind of cloth, as the user stated, if the surface is cloth. Default: judged by names. */
  readonly cloth?: ClothKind
}

export const AUTO_SETTINGS: AutoSettings = { strength: 1, size: 1024 }
