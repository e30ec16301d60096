import { readFileSync, writeFileSync } from 'node:fs'
import { beforeAll, describe, test } from 'vitest'
import { setOf } from '../../cases.ts'
import { editGlb } from '../../glb.ts'
import { bench } from './workshop.ts'

const FACE = 'faces/human.glb'
const { file, fails } = bench('render')

/** Tests the checks before the browser starts. Tests in `test/pages` check the pictures. */
describe('furrow render refuses', () => {
  beforeAll(() => {
    const put = (name: string, content: string | Uint8Array) => writeFileSync(file(name), content)
    const glb = readFileSync(FACE)
    put('text.glb', 'This is not a face, but it is longer than a header.')
    const strip = ({ materials }: { materials: { extensions?: object }[] }) => {
      for (const material of materials) delete material.extensions
    }
    put('bare.glb', editGlb(glb, strip))
    put('lone.json', JSON.stringify(setOf('layer.png')))
    put('up.json', JSON.stringify(setOf('../../etc/passwd')))
    put('far.json', JSON.stringify(setOf('https://example.org/layer.png')))
  })

  test.each<[string, string[], RegExp]>([
    ['a missing face', ['missing.glb'], /cannot read the face missing\.glb/],
    [
      'a wrinkle set that is not there',
      [file('bare.glb'), '--wrinkles', file('none.json')],
      /^furrow render: cannot read the wrinkles .*none\.json \(it does not exist\); check the path$/,
    ],
    [
      'an area of a face without wrinkles',
      [file('bare.glb'), '--activation', 'nose=1'],
      /the face has no areas, got "nose"; add wrinkles with furrow auto, or omit --activation$/,
    ],
    ['wrinkles in another folder', [FACE, '--wrinkles', file('up.json')], /outside its folder/],
    [
      'wrinkles that are no JSON',
      [FACE, '--wrinkles', file('text.glb')],
      /cannot read the wrinkles .*allowed: JSON/,
    ],
    ['wrinkles without images', [FACE, '--wrinkles', file('lone.json')], /cannot read .*layer\.png/],
    ['wrinkles on the network', [FACE, '--wrinkles', file('far.json')], /references a remote file/],
    ['an unknown blendshape', [FACE, '--set', 'jawOpenn=1'], /unknown blendshape, got "jawOpenn"/],
    ['an unknown area', [FACE, '--activation', 'chin=1'], /unknown area, got "chin"/],
  ])('%s', async (_, asked, message) => {
    // The output comes last, to end a list of weights.
    await fails(message, ...asked, '-o', file('x.png'))
  })
})
