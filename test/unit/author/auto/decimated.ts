import type { Document } from '@gltf-transform/core'
import type { Skin } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { decimate } from '../../../heads.ts'

/** Number of bisection steps that find the ratio for a number of vertices. */
const STEPS = 8

/** Returns the skin of a face whose mesh was reduced to about `vertices` vertices. */
export async function decimatedSkin(path: string, vertices: number): Promise<Skin> {
  let [low, high] = [0, 1]
  let nearest: Skin | undefined
  const distance = (skin: Skin) => Math.abs(skin.positions.length / 3 - vertices)
  for (let step = 0; step < STEPS; step++) {
    const ratio = (low + high) / 2
    const skin = await skinWith(path, ratio)
    if (!nearest || distance(skin) < distance(nearest)) nearest = skin
    if (skin.positions.length / 3 > vertices) high = ratio
    else low = ratio
  }
  return nearest!
}

async function skinWith(path: string, ratio: number): Promise<Skin> {
  const document: Document = await readDocument(path, 'test')
  await decimate(document, ratio)
  return findSkin(document, path, 'test').skin
}
