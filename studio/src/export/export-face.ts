import {
  type Cost,
  costOf,
  encodeGlb,
  type Finding,
  inspectWrinkles,
  PACK_DEFAULTS,
  packFace,
  type TargetNames,
  wrinklesOf,
} from 'furrow-files'
import { type FaceFiles, type Files, openFace, wrinkleFilesIn, wrinkleSetIn } from '../files/face-files.ts'
import { findingsOf } from './validate-face.ts'

/** How a face is written; all as the options of `furrow pack` of these names. */
export interface ExportOptions extends TargetNames {
  /** Maps and areas as KTX 2 arrays, which stay compressed on the GPU. */
  ktx2?: boolean
  /** Side in texels that the layers' maps are scaled to; by default they keep their size. */
  size?: number
  /** Side of the areas in texels; by default the document's, or 128. */
  areaSize?: number
}

/** A face with its wrinkles. */
export interface ExportedFace {
  /** As a `.glb`, whose name a `.vrm` may have too. */
  bytes: Uint8Array
  /** What `furrow validate` says about it. */
  findings: Finding[]
  cost: Cost
  /** What the artist should know about what she packed. */
  warnings: string[]
}

/** Called with the number of steps that are done, and of all. */
export type OnProgress = (done: number, total: number) => void

const WHO = 'Studio'

/**
 * Adds the wrinkles of a project to a face and validates the result, with the code of the command line: the bytes are those of
 * `furrow pack`.
 *
 * @param folder the project as `furrow pack` reads a folder; files of other names are ignored.
 * @throws FurrowError when the face or the wrinkles cannot be used.
 */
export async function exportFace(
  face: FaceFiles,
  folder: Files,
  { ktx2 = PACK_DEFAULTS.ktx2, ...options }: ExportOptions = {},
  onProgress: OnProgress = () => {},
): Promise<ExportedFace> {
  const document = wrinkleSetIn(folder, WHO)
  const glb = await openFace(face, WHO)
  const packOptions = { ...PACK_DEFAULTS, ...options, ktx2 }
  const read = wrinkleFilesIn(folder, WHO)
  const { target, warnings } = await packFace(glb, face.name, document, read, packOptions, WHO, onProgress)
  const bytes = encodeGlb(glb)
  const packed = await openFace({ name: face.name, bytes }, WHO)
  const findings = await findingsOf(packed)
  const report = await inspectWrinkles(wrinklesOf(packed, target.material, WHO), WHO)
  return { bytes, findings, cost: costOf(report, ktx2), warnings }
}
