import type { ShapeCorrection } from 'furrow/internal'
import type { StudioDocument } from './document.ts'

/**
 * Adds a correction of the meaning that was recognised for a blendshape. Inserts it at the start, because only the first
 * correction of a blendshape takes effect.
 *
 * @param correction must spell the names of the mesh and the blendshape as the avatar's file does.
 */
export function correctShape(document: StudioDocument, correction: ShapeCorrection): StudioDocument {
  const { shapes = [] } = document
  if (shapes.some((other) => isSame(other, correction))) return document
  const others = shapes.filter(({ mesh, target }) => mesh !== correction.mesh || target !== correction.target)
  return { ...document, shapes: [correction, ...others] }
}

/** Removes the corrections for which `matches` returns true. */
export function removeCorrections(
  document: StudioDocument,
  matches: (correction: ShapeCorrection) => boolean,
): StudioDocument {
  const { shapes = [], ...others } = document
  const left = shapes.filter((correction) => !matches(correction))
  if (left.length === shapes.length) return document
  return left.length === 0 ? others : { ...others, shapes: left }
}

/** Whether the corrections changed after the automatic wrinkles were made. */
export function hasOutdatedWrinkles({ shapes = [], auto }: Pick<StudioDocument, 'shapes' | 'auto'>): boolean {
  const made = auto?.shapes ?? []
  const isMade = (correction: ShapeCorrection) => made.some((other) => isSame(other, correction))
  return auto !== undefined && (made.length !== shapes.length || !shapes.every(isMade))
}

function isSame(a: ShapeCorrection, b: ShapeCorrection): boolean {
  return a.mesh === b.mesh && a.target === b.target && a.shape === b.shape
}
