import { simplify, weld } from '@gltf-transform/functions'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import { io, plainHuman } from './avatars.ts'
import { cutTexture } from './cut-texture.ts'
import { describeWay, HUMAN_HEIGHTS } from './studio-way.ts'

const LOW_POLY = 0.12

describeWay({
  kind: 'a low-polygon avatar',
  file: 'low.glb',
  heights: HUMAN_HEIGHTS,
  make: async () => {
    await MeshoptSimplifier.ready
    const document = await plainHuman()
    await document.transform(weld(), simplify({ simplifier: MeshoptSimplifier, ratio: LOW_POLY, error: 1 }))
    await cutTexture(document, 'skin')
    return io.writeBinary(document)
  },
})
