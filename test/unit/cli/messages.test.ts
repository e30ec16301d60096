import { execFileSync } from 'node:child_process'
import { closeSync, mkdirSync, openSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { nearestName } from 'furrow/internal'
import { cannotRead, cannotWrite, otherFormat } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import { describe, expect, it, vi } from 'vitest'
import { escaped, print, warn } from '../../../packages/cli/src/print.ts'
import type { CommandName } from '../../commands.ts'
import { editGlb } from '../../glb.ts'
import { faceBytes, Workshop } from './workshop.ts'

const shop = new Workshop()
const WHO = 'furrow test'
const errno = (code: string) => Object.assign(new Error(`${code}: something, open 'x'`), { code })

describe('a file system error', () => {
  it.each([
    ['ENOENT', 'furrow test: cannot read x (it does not exist); check the path'],
    ['EISDIR', 'furrow test: cannot read x (it is a folder); choose a file'],
    ['EACCES', 'furrow test: cannot read x (permission denied); ask its owner, or change its permissions'],
    ['ENAMETOOLONG', 'furrow test: cannot read x (the name is too long); choose a shorter name'],
    ['ESTRANGE', "furrow test: cannot read x (ESTRANGE: something, open 'x'); check the path"],
  ])('%s names the problem and the remedy', (code, message) => {
    expect(cannotRead(WHO, 'x', errno(code)).message).toBe(message)
  })

  it('has the remedy for a missing file only if the file is missing', () => {
    const hints = { remedy: 'put it beside the face' }
    expect(cannotRead(WHO, 'x', errno('ENOENT'), hints).message).toMatch(/; put it beside the face$/)
    expect(cannotRead(WHO, 'x', errno('EACCES'), hints).message).toMatch(/; ask its owner/)
    expect(cannotWrite(WHO, 'x', errno('ENOSPC')).message).toBe(
      'furrow test: cannot write x (the disk is full); free some space, or choose another disk',
    )
  })

  it('names the folder if a folder is given as the face', async () => {
    mkdirSync(shop.path('folder.glb'))
    await expect(readGlbFile(shop.path('folder.glb'), WHO)).rejects.toThrow(
      /it is a folder\); choose a file$/,
    )
  })
})

describe('a pipe as input', () => {
  it.each(['face.glb', 'wrinkles.json', 'areas/brow.png', 'layers/age/normal.png'])(
    'is refused instead of waiting: %s',
    async (name) => {
      const folder = await shop.makeFolder('pipes')
      rmSync(join(folder, name), { force: true })
      execFileSync('mkfifo', [join(folder, name)])
      const message = /it is (a device, pipe or socket|not a file)/
      await shop.fails(message, 'pack', folder, '-o', shop.path('pipes.glb'))
      rmSync(join(folder, name))
    },
  )

  it('is read if the shell has opened it', async () => {
    const bytes = await faceBytes()
    const file = openSync(shop.write('opened.glb', bytes), 'r')
    expect((await readGlbFile(`/dev/fd/${file}`, WHO)).fileBytes).toBe(bytes.length)
    closeSync(file)
  })
})

describe('a file that is not glTF', () => {
  it.each([
    [{ name: 'app', version: '1.0.0' }, /has no asset\.version/],
    [{ asset: {} }, /has no asset\.version/],
    [{ asset: { version: '1.0' } }, /it is glTF 1\.0/],
  ])('has a precise error if it is JSON: %j', async (json, message) => {
    await expect(readGlbFile(shop.json('other.gltf', json), WHO)).rejects.toThrow(message)
    const remedy = 'asset' in json ? 'download or export it again' : 'choose the face file'
    await expect(readGlbFile(shop.path('other.gltf'), WHO)).rejects.toMatchObject({ remedy })
  })

  it.each<[string, string, RegExp]>([
    ['Kaydara FBX Binary  \0', 'an FBX file', /FBX2glTF.*Blender/],
    ['; FBX 7.4.0 project file\n', 'an FBX file', /FBX2glTF.*Blender/],
    ['# made by hand\n\nmtllib a.mtl\nv 0 0 0\n', 'an OBJ file', /Blender/],
    ['v 0 0 0\nv 1 0 0\n', 'an OBJ file', /Blender/],
    [`PK\x03\x04${'\0'.repeat(26)}scene.usdc`, 'a USDZ file', /Blender/],
    [`PK\x03\x04${'\0'.repeat(26)}readme.txt`, 'an archive', /unpack/],
    ['PXR-USDC', 'a USD file', /Blender/],
    ['BLENDER-v300', 'a Blender file', /export/],
    ['<!DOCTYPE html><html>', 'a web page', /download/],
    ['\n <HTML lang="en">', 'a web page', /download/],
    ['version https://git-lfs.github.com/spec/v1\noid sha256:0\n', 'a pointer of Git LFS', /git lfs pull/],
    ['\x89PNG\r\n\x1a\n', 'an image', /not a texture/],
    ['\xabKTX 20\xbb\r\n\x1a\n', 'a KTX 2 file', /not a texture/],
    ['words, and more words', 'text, not glTF', /choose the face file/],
    ['[1, 2]\t\r\n', 'text, not glTF', /choose the face file/],
  ])('is recognised as %j, with a remedy', async (begin, kind, remedy) => {
    const path = shop.write('face.glb', Buffer.from(begin.padEnd(64), 'latin1'))
    const error = await readGlbFile(path, WHO).catch((error) => error)
    expect(error.message).toContain(`is not usable: it is ${kind}`)
    expect(error.remedy).toMatch(remedy)
  })

  it('has a remedy if it is incomplete, or older than glTF 2', async () => {
    const intact = await faceBytes()
    const problemOf = (bytes: Uint8Array) =>
      readGlbFile(shop.write('part.glb', bytes), WHO).catch(({ message }: Error) => message)
    for (let length = 0; length < intact.length; length += length < 50 ? 1 : 97)
      expect(await problemOf(intact.subarray(0, length)), `${length}`).toContain('is not usable: it is ')
    expect(await problemOf(intact.subarray(0, 10))).toContain('truncated after 10 bytes')
    expect(await problemOf(intact.subarray(0, 900))).toContain(`truncated: 900 of ${intact.length} bytes`)
    new DataView(intact.buffer, intact.byteOffset).setUint32(4, 1, true)
    expect(await problemOf(intact)).toMatch(/it has version 1.*; download or export it again$/)
  })

  it('has no special message if its format is unknown', () => {
    expect(otherFormat(Buffer.from([1, 2, 3, 4]))).toBeUndefined()
    // The patterns must also be fast on unfavourable text.
    expect(otherFormat(Buffer.from(`${'# '.repeat(10_000)}`))?.problem).toBe('it is text, not glTF')
  })
})

describe('another kind of file', async () => {
  const face = shop.write('swapped.glb', await faceBytes())
  const out = ['-o', shop.path('x.png')]

  it.each<[CommandName, string[], string]>([
    [
      'normals',
      [face, '--strength', '1', ...out],
      `cannot read the image ${face} (it is a binary glTF file), allowed: PNG, JPEG, WebP or TIFF; choose an image`,
    ],
    [
      'strokes',
      [face, '--face', face, ...out],
      `cannot read the strokes ${face} (it is a binary glTF file), allowed: JSON; correct the file, or choose another one`,
    ],
    ['array', [face, '--extract', shop.path('x')], '(it is a binary glTF file, not KTX 2), allowed: KTX 2'],
    [
      'pack',
      [face, '-o', shop.path('x.glb')],
      `furrow pack: ${face} is a file, allowed: a folder with layers/NAME/normal.png, areas/NAME.png and optionally` +
        ' wrinkles.json; generate wrinkles with furrow auto, or extract the wrinkles of a file with furrow unpack',
    ],
    [
      'inspect',
      ['https://example.org/a.glb'],
      'cannot read the face https://example.org/a.glb (it is a URL); download the file',
    ],
    ['activations', [face], 'swapped.glb has no wrinkles, allowed: '],
  ])('is recognised by furrow %s, with a remedy', async (command, args, message) => {
    await shop.fails(message, command, ...args)
  })

  it('in a folder to pack gives an error that names the folder', async () => {
    const folder = await shop.makeFolder('named')
    const document = shop.json('named/wrinkles.json', {})
    await shop.fails(`; name its folder, ${folder}`, 'pack', document, '-o', shop.path('x.glb'))
  })
})

describe('the nearest name', () => {
  const NAMES = ['jawOpen', 'browInnerUp', 'mouthSmileLeft', 'mouthSmileRight']

  it.each([
    ['jawOpenn', 'jawOpen'],
    ['JAWOPEN', 'jawOpen'],
    ['browInerUp', 'browInnerUp'],
    ['mouthSmileRihgt', 'mouthSmileRight'],
    ['tongueOut', undefined],
    ['x'.repeat(100_000), undefined],
  ])('of %.20s is %s', (name, expected) => {
    expect(nearestName(name, NAMES)).toBe(expected)
  })

  it.each<[CommandName, string[], string]>([
    ['pack', ['--mesh', 'skim'], 'skin'],
    ['pack', ['--mesh', 'eyes', '--material', 'eye'], 'eyes'],
    ['pack', ['--outptu', 'x.glb'], '--output'],
    ['activations', ['--set', 'jawOpne=1'], 'jawOpen'],
    ['activations', ['--expression', 'hapy'], 'happy'],
  ])('is suggested by furrow %s for %j: %s', async (command, args, name) => {
    const input =
      command === 'pack' ? [await shop.makeFolder('near'), '-o', shop.path('x.glb')] : ['faces/human.glb']
    await shop.fails(`; did you mean "${name}"?`, command, ...input, ...args)
  })
})

describe('printed text', () => {
  it('contains no terminal control codes from a file', () => {
    expect(escaped('a\x1b[2Jb\x07\x9bc')).toBe('a\\u001b[2Jb\\u0007\\u009bc')
    expect(escaped('two\nlines\r')).toBe('two\\u000alines\\u000d')
    expect(escaped('\u202eevil\u2066\u200f')).toBe('\\u202eevil\\u2066\\u200f')
    expect(escaped('Ünï © 日本語 👩‍🚀')).toBe('Ünï © 日本語 👩‍🚀')
  })

  it('stays JSON with the same values', () => {
    const value = { name: 'a\x1b\x9b\u202e\n' }
    expect(JSON.parse(escaped(JSON.stringify(value)))).toEqual(value)
  })

  it('goes to stderr if stdout receives a file', () => {
    const stderr = vi.spyOn(process.stderr, 'write').mockReturnValue(true)
    print('to stdout', 'x.png', undefined)
    print('to stderr', 'x.png', '-')
    expect(shop.printed).toBe('to stdout\n')
    expect(stderr.mock.calls).toEqual([['to stderr\n']])
    stderr.mockRestore()
  })

  it('has one message per line', () => {
    print(['one\ntwo', 'three'])
    warn('four\nfive')
    expect(shop.printed).toBe('one\\u000atwo\nthree\n')
    expect(shop.warned).toBe('four\\u000afive\n')
  })

  it('shows hostile names from a file harmlessly', async () => {
    const folder = await shop.makeFolder('hostile')
    shop.write(
      'hostile/face.glb',
      editGlb(await faceBytes(), (json) => {
        json.materials[0].name = 'skin\x1b[31m\nerror: all is lost'
      }),
    )
    await shop.run('pack', folder, '-o', shop.path('hostile.glb'), '--mesh', 'skin')
    await shop.run('inspect', shop.path('hostile.glb'))
    expect(shop.printed).toContain('skin\\u001b[31m\\u000aerror: all is lost')
    expect(shop.printed).not.toContain('\x1b')
  })
})
