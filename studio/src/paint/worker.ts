/** Worker that prepares the skin of a face for the tools. */

import { expose, transfer } from 'comlink'
import { type MetricMesh, type Skin, skinCanvas } from 'furrow/author'
import { buffersOf, canvasArrays, type SkinCanvasArrays } from 'furrow/internal'
import { holdLifeLock } from '../workers/life.ts'
import { makeSkin, type SkinData } from './make-skin.ts'

const service = {
  /** Runs `makeSkin`. Transfers the skin back with the result, because the page has transferred it to the worker. */
  makeSkin(skin: Skin, scale: number, size: number): { skin: Skin; made: SkinData } {
    const answer = { skin, made: makeSkin(skin, scale, size) }
    return transfer(answer, [...buffersOf(answer), ...(answer.made.hierarchy.roots as ArrayBuffer[])])
  },
  /** See `skinCanvas`. */
  makeCanvas(mesh: MetricMesh, size: number, scale: number): SkinCanvasArrays {
    const arrays = canvasArrays(skinCanvas(mesh, size, size, scale))
    return transfer(arrays, buffersOf(arrays))
  },
}

export type SkinService = typeof service

expose(service)
holdLifeLock()
