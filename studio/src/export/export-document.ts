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
import { addTakes } from './add-takes.ts'
import { setToPack } from './set-to-pack.ts'
import { findingsOf } from './validate-face.ts'

/** Options of `furrow pack` that the studio offers. */
export interface ExportOptions extends TargetNames {
  /** Whether maps and areas are stored as KTX 2 array textures, which stay compressed on the GPU. */
  ktx2?: boolean
  /** Width and height of the layers' maps, texels. Default: their sizes in the document. */
  size?: number
  /** Width and height of the areas, texels. Default: `areaSize` of the document. */
  areaSize?: number
  /** Whether to add the document's takes as animations. Default: true. */
  takes?: boolean
}

/** File of a face with its wrinkles, and a report about the file. */
export interface ExportedFace {
  /** `.glb` file. If the face was a `.vrm`, it is also a valid `.vrm`. */
  bytes: Uint8Array
  /** Findings of `furrow validate`. */
  findings: Finding[]
  cost: Cost
  warnings: string[]
}

/** Receives the number of completed steps and the number of all steps. */
export type OnProgress = (done: number, total: number) => void

const WHO = 'Studio'

/**
 * Adds the wrinkles of a document to a face and validates the result. Without takes, the bytes are the same as those that `furrow pack`
 * makes from the document's project folder.
 *
 * @throws FurrowError if the face or the wrinkles are invalid.
 */
export async function exportDocument(
  face: FaceFiles,
  source: DocumentToPack,
  { ktx2 = PACK_DEFAULTS.ktx2, takes = true, ...options }: ExportOptions = {},
  onProgress: OnProgress = () => {},
): Promise<ExportedFace> {
  const set = setToPack(source, WHO)
  const glb = await openFace(face, WHO)
  const packOptions = { ...PACK_DEFAULTS, ...options, ktx2 }
  const { target, warnings } = await packFace(glb, face.name, set, packOptions, WHO, onProgress)
  if (takes) addTakes(glb, source.document.takes ?? [])
  const bytes = encodeGlb(glb)
  const packed = await openFace({ name: face.name, bytes }, WHO)
  const findings = await findingsOf(packed)
  const report = await inspectWrinkles(parseWrinkledFile(packed, target.material, WHO), WHO)
  return { bytes, findings, cost: costOf(report, ktx2), warnings }
}
