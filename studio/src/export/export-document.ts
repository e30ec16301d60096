import {
  type Cost,
  costOf,
  encodeGlb,
  type Finding,
  inspectWrinkles,
  PACK_DEFAULTS,
  packFace,
  parseWrinkledFile,
  type TargetNames,
} from 'furrow-files'
import type { DocumentToPack } from '../document/packed-layers.ts'
import { type FaceFiles, openFace } from '../files/face-files.ts'
import { setToPack } from './set-to-pack.ts'
import { findingsOf } from './validate-face.ts'

/** How a face is written; all as the options of `furrow pack` of these names. */
export interface ExportOptions extends TargetNames {
  /** Maps and areas as KTX 2 arrays, which stay compressed on the GPU. */
  ktx2?: boolean
  /** Side in texels that the layers' maps are scaled to; by default they keep their size. */
  size?: number
  /** Side of the areas in texels; by default the document's. */
  areaSize?: number
}

/** A face with its wrinkles. */
export interface ExportedFace {
  /** As a `.glb`, whose name a `.vrm` may have too. */
  bytes: Uint8Array
  /** Findings of `furrow validate`. */
  findings: Finding[]
  cost: Cost
  /** Warnings for the artist. */
  warnings: string[]
}

/** Called with the number of steps that are done, and of all. */
export type OnProgress = (done: number, total: number) => void

const WHO = 'Studio'

/**
 * Adds the wrinkles of a document to a face and validates the result. The bytes are those of `furrow pack` on the folder of the document.
 *
 * @throws FurrowError when the face or the wrinkles cannot be used.
 */
export async function exportDocument(
  face: FaceFiles,
  source: DocumentToPack,
  { ktx2 = PACK_DEFAULTS.ktx2, ...options }: ExportOptions = {},
  onProgress: OnProgress = () => {},
): Promise<ExportedFace> {
  const set = setToPack(source, WHO)
  const glb = await openFace(face, WHO)
  const packOptions = { ...PACK_DEFAULTS, ...options, ktx2 }
  const { target, warnings } = await packFace(glb, face.name, set, packOptions, WHO, onProgress)
  const bytes = encodeGlb(glb)
  const packed = await openFace({ name: face.name, bytes }, WHO)
  const findings = await findingsOf(packed)
  const report = await inspectWrinkles(parseWrinkledFile(packed, target.material, WHO), WHO)
  return { bytes, findings, cost: costOf(report, ktx2), warnings }
}
