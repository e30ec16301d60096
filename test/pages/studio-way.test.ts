import { existsSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { turnScene } from '../avatar.ts'
import { asVrm0 } from '../vrm.ts'
import { io, plainHuman } from './avatars.ts'
import { cutTexture } from './cut-texture.ts'
import { describeWay, HUMAN_HEIGHTS } from './studio-way.ts'

const SCAN = fileURLToPath(new URL('../../../shared/real-face/ict-face.glb', import.meta.url))

describeWay({
  kind: 'a scan (without ../shared/real-face: nothing)',
  file: 'scan.glb',
  heights: { forehead: 0.145, chin: 0.62 },
  make: async () => {
    if (!existsSync(SCAN)) return null
    const document = await io.read(SCAN)
    await cutTexture(document, 'face')
    return io.writeBinary(document)
  },
})

describeWay({
  kind: 'a VRM',
  file: 'avatar.vrm',
  heights: HUMAN_HEIGHTS,
  make: async () => {
    const document = await plainHuman()
    await cutTexture(document, 'skin')
    turnScene(document, 180)
    return asVrm0(await io.writeBinary(document))
  },
})
