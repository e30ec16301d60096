import type { AutoSettings, MapName, StudioDocument } from '../document/document.ts'

/**
 * `studio.json`: what the studio knows of a folder beyond what `furrow pack` reads, which ignores it. A folder made by hand has none, and
 * everything in it is optional.
 */
export interface StudioFile {
  version: 1
  /** As in `strokes.json`, for folders without strokes. */
  scale?: number
  mapSize?: number
  auto?: AutoSettings
  /** Names of automatic areas, and indices of automatic strokes. */
  automaticAreas?: string[]
  automaticStrokes?: number[]
  /** Names of layers whose blood map is automatic. */
  automaticBlood?: string[]
  /** By the layer's name. */
  layers?: Record<string, DrawnLayer>
  face?: FaceFile
  /** Paths of the images that the studio wrote: those that it may delete. */
  files?: string[]
}

/** A layer that has other maps in the document than in the folder. */
export interface DrawnLayer {
  /** Maps of the folder that were drawn from strokes. */
  drawn: MapName[]
  /** Addresses of the maps that strokes were drawn over. */
  under?: { [Name in MapName]?: string }
  heightAmplitude?: number
}

export interface FaceFile {
  /** Path of the face in the folder. */
  path: string
  /** Path that it was opened from. */
  name: string
}

export const STUDIO_FILE = 'studio.json'
/** Where maps are that strokes were drawn over. */
export const UNDER = 'under'
/** Where a face is that has files beside it. */
export const FACE_FOLDER = 'face'

/** What is automatic in a document. */
export function automaticParts({ layers, areas, strokes }: StudioDocument) {
  return {
    automaticAreas: areas.flatMap(({ name, isAutomatic }) => (isAutomatic ? [name] : [])),
    automaticStrokes: strokes.flatMap(({ isAutomatic }, i) => (isAutomatic ? [i] : [])),
    automaticBlood: layers.flatMap(({ name, isBloodAutomatic }) => (isBloodAutomatic ? [name] : [])),
  }
}

/** `studio.json` of a folder; what it should not be counts as absent, as the document is whole without it. */
export function parseStudioFile(json: unknown): StudioFile {
  const isUsable = typeof json === 'object' && json !== null && (json as StudioFile).version === 1
  return isUsable ? (json as StudioFile) : { version: 1 }
}
