/** Makes the skin of a face ready for tools, away from the page. */

import { expose, transfer } from 'comlink'
import type { Skin } from 'furrow/author'
import { buffersOf } from '../../../packages/furrow/src/auto/buffers.ts'
import { holdLife } from '../workers/life.ts'
import { type MadeSkin, makeSkin } from './make-skin.ts'

const service = {
  makeSkin(skin: Skin, scale: number, size: number): MadeSkin {
    const made = makeSkin(skin, scale, size)
    return transfer(made, [...buffersOf(made), ...(made.hierarchy.roots as ArrayBuffer[])])
  },
}

export type SkinService = typeof service

expose(service)
holdLife()
