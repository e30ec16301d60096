import { FurrowError } from 'furrow'
import { bakeMaps } from 'furrow/author'
import { meshDiagonal } from 'furrow/internal'
import {
  DEFAULT_CAGE,
  documentOf,
  encodePortablePng,
  lowMeshOf,
  nameOf,
  raySourceOf,
  surfaceOf,
  trianglesOf,
} from 'furrow-files'
import { type FaceFiles, openFace } from '../files/face-files.ts'
import type { OnProgress } from './export-document.ts'

const WHO = 'Studio'

/** Mesh of a face, for which a sculpt is baked. */
export interface BakeTarget {
  face: FaceFiles
  /** Mesh name. Default: the first mesh with texture coordinates. */
  mesh?: string | undefined
  /** Width and height of the normal map, texels. */
  size: number
}

/**
 * Bakes a sculpt (a detailed model of the wrinkled face) into a normal map for a face. Works like `furrow bake --tangents derivative`, because
 * three.js computes missing tangents from screen-space derivatives.
 *
 * @returns PNG file.
 * @throws FurrowError if a model is invalid, or if the two models do not overlap.
 */
export async function bakeSculpt(
  sculpt: FaceFiles,
  { face, mesh: meshName, size }: BakeTarget,
  onProgress: OnProgress = () => {},
): Promise<Uint8Array> {
  const surface = surfaceOf(await readDocument(sculpt), sculpt.name, WHO)
  const nodes = (await readDocument(face))
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh())
  const usable = nodes.filter((node) => trianglesOf(node.getMesh()!).length > 0)
  const node = usable.find((each) => nameOf(each) === meshName) ?? usable.at(0)
  if (!node) throw noSkinError(face.name)
  const { mesh } = lowMeshOf(node, face.name, WHO)
  const cage = DEFAULT_CAGE * meshDiagonal(mesh)
  const { normal } = bakeMaps(mesh, raySourceOf(surface), { size, cage }, onProgress)
  return encodePortablePng({ width: size, height: size, channels: 3, data: normal.data as Uint8Array })
}

async function readDocument(file: FaceFiles) {
  return documentOf(await openFace(file, WHO), file.name, WHO)
}

function noSkinError(face: string): FurrowError {
  return new FurrowError({
    who: WHO,
    problem: `no mesh of ${face} has texture coordinates`,
    remedy: 'unwrap it, and export it again',
  })
}
