import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { beforeAll, describe, test } from 'vitest'
import { renderCommand } from '../../../packages/cli/src/commands/render.ts'
import { setOf } from '../../cases.ts'
import { editGlb } from '../../glb.ts'
import { bench } from './command.ts'

const FACE = 'faces/human.glb'
const { file, fails, folder } = bench(renderCommand)

/** All before a browser is started; what one must be started for is with the pages. */
describe('furrow render refuses', () => {
  beforeAll(() => {
    const put = (name: string, content: string | Uint8Array) => writeFileSync(file(name), content)
    const glb = readFileSync(FACE)
    const old = Buffer.from(glb)
    old.writeUInt32LE(1, 4)
    put('empty.glb', '')
    put('text.glb', 'This is no face, but it is longer than a header.')
    put('short.glb', glb.subarray(0, 10))
    put('cut.glb', glb.subarray(0, 50_000))
    put('old.glb', old)
    const strip = ({ materials }: { materials: { extensions?: object }[] }) => {
      for (const material of materials) delete material.extensions
    }
    put('bare.glb', editGlb(glb, strip))
    put('lone.json', JSON.stringify(setOf('layer.png')))
    put('far.json', JSON.stringify(setOf('https://example.org/layer.png')))
    mkdirSync(file('folder.png'))
  })

  test.each<[string, string[], RegExp]>([
    ['a missing face', ['missing.glb'], /cannot read the face missing\.glb/],
    ['an empty face', [file('empty.glb')], /it is empty/],
    ['a text', [file('text.glb')], /does not begin with "glTF"/],
    ['a face cut off in its header', [file('short.glb')], /cut off after 10 bytes/],
    ['a face cut off', [file('cut.glb')], /cut off: 50000 of \d+ bytes/],
    ['glTF 1', [file('old.glb')], /of version 1/],
    ['a folder', [folder], /cannot read the face/],
    ['a face without wrinkles', [file('bare.glb')], /cannot read the wrinkles .*--wrinkles/],
    ['wrinkles that are no JSON', [FACE, '--wrinkles', file('text.glb')], /are no JSON/],
    ['wrinkles without images', [FACE, '--wrinkles', file('lone.json')], /cannot read .*layer\.png/],
    ['wrinkles on the network', [FACE, '--wrinkles', file('far.json')], /not on this computer/],
    ['an unknown expression', [FACE, '--expression', 'bored'], /unknown expression, got "bored"/],
    ['an unknown blendshape', [FACE, '--set', 'jawOpenn=1'], /unknown blendshape, got "jawOpenn"/],
    ['an unknown area', [FACE, '--activation', 'chin=1'], /unknown area, got "chin"/],
    ['an unknown view', [FACE, '--view', 'top'], /unknown view, got "top"/],
    ['an unknown mode', [FACE, '--mode', 'on'], /unknown mode, got "on"/],
    ['an unknown renderer', [FACE, '--renderer', 'metal'], /unknown renderer, got "metal"/],
    ['a weight that is no number', [FACE, '--set', 'jawOpen=wide'], /no weight, got "jawOpen=wide"/],
    ['a weight without a number', [FACE, '--set', 'jawOpen='], /no weight/],
    ['a weight without a name', [FACE, '--set', '=1'], /no weight/],
    ['a weight above 1', [FACE, '--set', 'jawOpen=1.5'], /no weight, got "jawOpen=1.5"/],
    ['an activation below 0', [FACE, '--activation', 'nose=-1'], /no weight, got "nose=-1"/],
    ['an activation not a number', [FACE, '--activation', 'nose=NaN'], /no weight/],
    ['a size of one number', [FACE, '--size', '800'], /no size of a picture, got "800"/],
    ['a size too small', [FACE, '--size', '800x15'], /no size of a picture/],
    ['a size too large', [FACE, '--size', '8193x600'], /16\.\.8192/],
    ['a picture that is no PNG', [FACE, '-o', 'face.jpg'], /does not end in \.png/],
    ['a picture that is a folder', [FACE, '-o', file('folder.png')], /it is a folder/],
    ['a picture under a file', [FACE, '-o', join(file('text.glb'), 'x.png')], /is not a folder/],
  ])('%s', async (_, asked, message) => {
    const output = asked.includes('-o') ? [] : ['-o', file('x.png')]
    // No option of the command follows, so that a list of weights ends where it should.
    await fails(message, ...asked, ...output)
  })
})
