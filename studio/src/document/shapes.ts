import type { ShapeCorrection } from 'furrow/internal'
import type { StudioDocument } from './document.ts'

/**
 * Corrects what a blendshape is. Of several corrections that name it the first counts, so that this one is first.
 *
 * @param correction names mesh and blendshape as they are spelled in the file.
 */
export function correctShape(document: StudioDocument, correction: ShapeCorrection): StudioDocument {
  const { shapes = [] } = document
  if (shapes.some((other) => isSame(other, correction))) return document
  const others = shapes.filter(({ mesh, target }) => mesh !== correction.mesh || target !== correction.target)
  return { ...document, shapes: [correction, ...others] }
}

/** Removes the corrections for which a function says so. */
export function removeCorrections(
  document: StudioDocument,
  isOne: (correction: ShapeCorrection) => boolean,
): StudioDocument {
  const { shapes = [], ...others } = document
  const left = shapes.filter((correction) => !isOne(correction))
  if (left.length === shapes.length) return document
  return left.length === 0 ? others : { ...others, shapes: left }
}

/** Whether the automatic wrinkles were made with other corrections than the document has now. */
export function areWrinklesOutdated({ shapes = [], auto }: Pick<StudioDocument, 'shapes' | 'auto'>): boolean {
  const made = auto?.shapes ?? []
  const isMade = (correction: ShapeCorrection) => made.some((other) => isSame(other, correction))
  return auto !== undefined && (made.length !== shapes.length || !shapes.every(isMade))
}

function isSame(a: ShapeCorrection, b: ShapeCorrection): boolean {
  return a.mesh === b.mesh && a.target === b.target && a.shape === b.shape
}
