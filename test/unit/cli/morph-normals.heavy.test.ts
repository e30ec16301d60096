import { readFileSync } from 'node:fs'
import { type Accessor, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { Vector3 } from 'three'
import { beforeAll, describe, expect, it } from 'vitest'
import { editGlb } from '../../glb.ts'
import { Workshop } from './workshop.ts'

const shop = new Workshop()
const packed = () => shop.path('packed.glb')

interface Json {
  meshes: { primitives: { targets: Record<string, number>[] }[] }[]
}

beforeAll(() => {
  // Removes the normals of the blendshapes from the shipped face.
  const bare = editGlb(readFileSync('faces/human.glb'), ({ meshes }: Json) => {
    for (const target of meshes[0].primitives[0].targets) delete target.NORMAL
  })
  shop.write('bare.glb', bare)
})

const skinOf = async (path: string) => {
  const document = await new NodeIO().registerExtensions(ALL_EXTENSIONS).read(path)
  return document.getRoot().listMeshes()[0].listPrimitives()[0]
}

const vectorAt = (accessor: Accessor, i: number) => new Vector3().fromArray(accessor.getElement(i, []))

describe('furrow pack --morph-normals', () => {
  it('gives every blendshape normals, close to those of the script that built the face', async () => {
    await shop.run('pack', 'faces/human', '--face', shop.path('bare.glb'), '--morph-normals', '-o', packed())
    expect(shop.printed).toContain('blendshapes that got normals: 52')
    const [built, made] = [await skinOf('faces/human.glb'), await skinOf(packed())]
    const rest = built.getAttribute('NORMAL')!
    const angles: number[] = []
    for (const [k, target] of built.listTargets().entries()) {
      const [a, b] = [target, made.listTargets()[k]].map((own) => own.getAttribute('NORMAL')!)
      for (let i = 0; i < rest.getCount(); i += 7) {
        const base = vectorAt(rest, i)
        const [p, q] = [a, b].map((own) => vectorAt(own, i).add(base))
        if (p.angleTo(base) > 0.02) angles.push(p.angleTo(q))
      }
    }
    angles.sort((x, y) => x - y)
    expect(angles.length).toBeGreaterThan(5000)
    // Angles in radians: half of the normals are within 0.6 degrees. The worst 5% are on lids and lips, which fold.
    expect(angles[Math.floor(angles.length / 2)]).toBeLessThan(0.01)
    expect(angles[Math.floor(0.95 * angles.length)]).toBeLessThan(0.15)
  })

  it('writes a valid file, and keeps existing normals', async () => {
    shop.printed = ''
    await shop.run('validate', packed())
    expect(shop.printed).toMatch(/0 errors/)
    shop.printed = ''
    await shop.run(
      'pack',
      'faces/human',
      '--face',
      'faces/human.glb',
      '--morph-normals',
      '-o',
      shop.path('same.glb'),
    )
    expect(shop.printed).not.toContain('got normals')
  })
})
