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
    put('text.glb', 'This is not a face, but it is longer than a header.')
    put('short.glb', glb.subarray(0, 10))
    put('cut.glb', glb.subarray(0, 50_000))
    put('old.glb', old)
    const strip = ({ materials }: { materials: { extensions?: object }[] }) => {
      for (const material of materials) delete material.extensions
    }
    put('bare.glb', editGlb(glb, strip))
    put('lone.json', JSON.stringify(setOf('layer.png')))
    put('up.json', JSON.stringify(setOf('../../etc/passwd')))
    put('far.json', JSON.stringify(setOf('https://example.org/layer.png')))
    mkdirSync(file('folder.png'))
  })

  test.each<[string, string[], RegExp]>([
    ['a missing face', ['missing.glb'], /cannot read the face missing\.glb/],
    ['an empty face', [file('empty.glb')], /it is empty/],
    ['a text', [file('text.glb')], /it is text, not glTF/],
    ['a face cut off in its header', [file('short.glb')], /cut off after 10 bytes/],
    ['a face cut off', [file('cut.glb')], /cut off: 50000 of \d+ bytes/],
    ['glTF 1', [file('old.glb')], /it has version 1/],
    ['a folder', [folder], /cannot read the face/],
    [
      'a wrinkle set that is not there',
      [file('bare.glb'), '--wrinkles', file('none.json')],
      /^furrow render: cannot read the wrinkles .*none\.json \(it does not exist\); check the path$/,
    ],
    [
      'an area of a face without wrinkles',
      [file('bare.glb'), '--activation', 'nose=1'],
      /the face has no areas, got "nose"; make wrinkles with furrow auto, or leave --activation out$/,
    ],
    ['wrinkles in another folder', [FACE, '--wrinkles', file('up.json')], /outside its folder/],
    [
      'wrinkles that are no JSON',
      [FACE, '--wrinkles', file('text.glb')],
      /cannot read the wrinkles .*allowed: JSON/,
    ],
    ['wrinkles without images', [FACE, '--wrinkles', file('lone.json')], /cannot read .*layer\.png/],
    ['wrinkles on the network', [FACE, '--wrinkles', file('far.json')], /not on this computer/],
    [
      'an unknown expression',
      [FACE, '--expression', 'bored'],
      /option '--expression <name>' argument 'bored' is invalid/,
    ],
    ['an unknown blendshape', [FACE, '--set', 'jawOpenn=1'], /unknown blendshape, got "jawOpenn"/],
    ['an unknown area', [FACE, '--activation', 'chin=1'], /unknown area, got "chin"/],
    ['an unknown view', [FACE, '--view', 'top'], /option '--view <name>' argument 'top' is invalid/],
    ['an unknown mode', [FACE, '--mode', 'on'], /option '--mode <name>' argument 'on' is invalid/],
    ['an unknown relief', [FACE, '--relief', 'yes'], /option '--relief <when>' argument 'yes' is invalid/],
    [
      'an unknown renderer',
      [FACE, '--renderer', 'metal'],
      /option '--renderer <name>' argument 'metal' is invalid/,
    ],
    ['a weight that is not a number', [FACE, '--set', 'jawOpen=wide'], /argument 'jawOpen=wide' is invalid/],
    ['a weight without a number', [FACE, '--set', 'jawOpen='], /argument 'jawOpen=' is invalid/],
    ['a weight without a name', [FACE, '--set', '=1'], /argument '=1' is invalid/],
    [
      'a weight above 1',
      [FACE, '--set', 'jawOpen=1.5'],
      /argument 'jawOpen=1\.5' is invalid. It must be NAME=VALUE/,
    ],
    ['an activation below 0', [FACE, '--activation', 'nose=-1'], /argument 'nose=-1' is invalid/],
    ['an activation not a number', [FACE, '--activation', 'nose=NaN'], /argument 'nose=NaN' is invalid/],
    ['a size of one number', [FACE, '--size', '800'], /option '--size <size>' argument '800' is invalid/],
    ['a size too small', [FACE, '--size', '800x15'], /argument '800x15' is invalid/],
    ['a size too large', [FACE, '--size', '8193x600'], /sides from 16 to 8192 pixels/],
    ['a picture that is not a PNG', [FACE, '-o', 'face.jpg'], /does not end in \.png/],
    ['a picture that is a folder', [FACE, '-o', file('folder.png')], /it is a folder/],
    ['a picture under a file', [FACE, '-o', join(file('text.glb'), 'x.png')], /is not a folder/],
  ])('%s', async (_, asked, message) => {
    const output = asked.includes('-o') ? [] : ['-o', file('x.png')]
    // No option of the command follows, so that a list of weights ends where it should.
    await fails(message, ...asked, ...output)
  })
})
