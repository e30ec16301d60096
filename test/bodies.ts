import type { Document } from '@gltf-transform/core'
import { skinnedFile } from './skinned-file.ts'
import { dress } from './unit/author/auto/limbs/dress.ts'
import { robot } from './unit/author/auto/limbs/robot.ts'

const SHELL = { colour: [0.6, 0.62, 0.66], roughness: 0.35 } as const

/** Returns a robot of hard parts, which only its material tells from skin and cloth. */
export function robotFile(): Document {
  return skinnedFile([
    { name: 'frame', material: { ...SHELL, name: 'shell', metalness: 0.8 }, skin: robot() },
  ])
}

/** Returns a dress on a stand of hard parts. */
export function dressFile(): Document {
  return skinnedFile([
    { name: 'dress', material: { name: 'dress', colour: [0.3, 0.1, 0.14] }, skin: dress() },
    { name: 'stand', material: { ...SHELL, name: 'plastic' }, skin: robot() },
  ])
}
