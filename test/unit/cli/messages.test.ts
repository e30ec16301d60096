import { execFileSync } from 'node:child_process'
import { closeSync, mkdirSync, openSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import type { Command } from 'commander'
import { nearestName } from 'furrow/internal'
import { cannotRead, cannotWrite, otherFormat } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import { describe, expect, it, vi } from 'vitest'
import { activationsCommand } from '../../../packages/cli/src/commands/activations.ts'
import { arrayCommand } from '../../../packages/cli/src/commands/array.ts'
import { inspectCommand } from '../../../packages/cli/src/commands/inspect.ts'
import { normalsCommand } from '../../../packages/cli/src/commands/normals.ts'
import { packCommand } from '../../../packages/cli/src/commands/pack.ts'
import { strokesCommand } from '../../../packages/cli/src/commands/strokes.ts'
import { escaped, print, warn } from '../../../packages/cli/src/print.ts'
import { editGlb } from '../../glb.ts'
import { faceBytes, Workshop } from './workshop.ts'

const shop = new Workshop()
const WHO = 'furrow test'
const errno = (code: string) => Object.assign(new Error(`${code}: something, open 'x'`), { code })

describe('an error of the file system', () => {
  it.each([
    ['ENOENT', 'furrow test: cannot read x (it does not exist); check the path'],
    ['EISDIR', 'furrow test: cannot read x (it is a folder); name a file'],
    ['EACCES', 'furrow test: cannot read x (permission denied); ask its owner, or change its permissions'],
    ['ENAMETOOLONG', 'furrow test: cannot read x (its name is too long); choose a shorter name'],
    ['ESTRANGE', "furrow test: cannot read x (ESTRANGE: something, open 'x'); check the path"],
  ])('%s says what is wrong and what helps', (code, message) => {
    expect(cannotRead(WHO, 'x', errno(code)).message).toBe(message)
  })

  it('has the remedy of the file only where that is missing', () => {
    const hints = { remedy: 'put it beside the face' }
    expect(cannotRead(WHO, 'x', errno('ENOENT'), hints).message).toMatch(/; put it beside the face$/)
    expect(cannotRead(WHO, 'x', errno('EACCES'), hints).message).toMatch(/; ask its owner/)
    expect(cannotWrite(WHO, 'x', errno('ENOSPC')).message).toBe(
      'furrow test: cannot write x (the disk is full); free some space, or choose another disk',
    )
  })

  it('about a folder in place of the face names the folder', async () => {
    mkdirSync(shop.path('folder.glb'))
    await expect(readGlbFile(shop.path('folder.glb'), WHO)).rejects.toThrow(/it is a folder\); name a file$/)
  })
})

describe('a pipe in place of an input', () => {
  it.each(['face.glb', 'wrinkles.json', 'areas/brow.png', 'layers/age/normal.png'])(
    'is refused rather than waited for: %s',
    async (name) => {
      const folder = await shop.makeFolder('pipes')
      rmSync(join(folder, name), { force: true })
      execFileSync('mkfifo', [join(folder, name)])
      const failure = shop.failure(packCommand, folder, '-o', shop.path('pipes.glb'))
      expect((await failure).message).toMatch(/it is (a device, pipe or socket|not a file)/)
      rmSync(join(folder, name))
    },
  )

  it('is read where the shell has opened it', async () => {
    const bytes = await faceBytes()
    const file = openSync(shop.write('opened.glb', bytes), 'r')
    expect((await readGlbFile(`/dev/fd/${file}`, WHO)).fileBytes).toBe(bytes.length)
    closeSync(file)
  })
})

describe('the help of a command', () => {
  const commands = import.meta.glob<Record<string, Command>>('../../../packages/cli/src/**/commands/*.ts', {
    eager: true,
  })

  it.each(Object.values(commands).flatMap((module) => Object.values(module)))(
    'has examples: $_name',
    (command) => {
      command.outputHelp()
      expect(shop.printed).toMatch(new RegExp(`^Examples?:\n  \\$ furrow ${command.name()} `, 'm'))
    },
  )
})

describe('a file that is not glTF', () => {
  it.each([
    [{ name: 'app', version: '1.0.0' }, /has no asset\.version/],
    [{ asset: {} }, /has no asset\.version/],
    [{ asset: { version: '1.0' } }, /it is glTF 1\.0/],
  ])('but JSON is told apart: %j', async (json, message) => {
    await expect(readGlbFile(shop.json('other.gltf', json), WHO)).rejects.toThrow(message)
    const remedy = 'asset' in json ? 'download or export it again' : 'name the face itself'
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
    ['\x89PNG\r\n\x1a\n', 'an image', /textures/],
    ['\xabKTX 20\xbb\r\n\x1a\n', 'a KTX 2 file', /textures/],
    ['words, and more words', 'text, not glTF', /name the face/],
    ['[1, 2]\t\r\n', 'text, not glTF', /name the face/],
  ])('%j is named, with what to do', async (begin, what, remedy) => {
    const path = shop.write('face.glb', Buffer.from(begin.padEnd(64), 'latin1'))
    const error = await readGlbFile(path, WHO).catch((error) => error)
    expect(error.message).toContain(`is not usable: it is ${what}`)
    expect(error.remedy).toMatch(remedy)
  })

  it('but empty is to be fetched again', async () => {
    await expect(readGlbFile(shop.write('empty.glb', ''), WHO)).rejects.toThrow(
      /it is empty, .*; download or export it again$/,
    )
  })

  it('is not named where nothing is known', () => {
    expect(otherFormat(Buffer.from([1, 2, 3, 4]))).toBeUndefined()
    // Patterns must not take long either.
    expect(otherFormat(Buffer.from(`${'# '.repeat(10_000)}`))?.problem).toBe('it is text, not glTF')
  })
})

describe('a file of another kind', () => {
  it('is named in place of an image, an array or a document', async () => {
    const face = shop.write('swapped.glb', await faceBytes())
    const fails = async (command: Command, ...args: string[]) =>
      (await shop.failure(command, ...args, '-o', shop.path('x.png'))).message
    expect(await fails(normalsCommand, face, '--strength', '1')).toContain(
      `cannot read the image ${face} (it is a binary glTF file), allowed: PNG, JPEG, WebP or TIFF; name an image`,
    )
    expect(await fails(strokesCommand, face, '--face', face)).toContain(
      `cannot read the strokes ${face} (it is a binary glTF file), allowed: JSON; correct the file, or name another one`,
    )
    const pattern = await shop.failure(arrayCommand, shop.path('*.png'), '-o', shop.path('x.ktx2'))
    expect(pattern.message).toMatch(/cannot read the image .*\*\.png \(it does not exist\); check the path$/)
    const array = await shop.failure(arrayCommand, face, '--extract', shop.path('x'))
    expect(array.message).toContain(`(it is a binary glTF file, not KTX 2), allowed: KTX 2`)
  })

  it('in place of a folder to pack says what to pack, and how to come by it', async () => {
    const face = shop.write('avatar.glb', await faceBytes())
    const pack = async (path: string) =>
      (await shop.failure(packCommand, path, '-o', shop.path('x.glb'))).message
    expect(await pack(face)).toBe(
      `furrow pack: ${face} is a file, allowed: a folder with layers/NAME/normal.png, areas/NAME.png and optionally` +
        ' wrinkles.json; make wrinkles for an avatar with furrow auto, or take them out of a file with furrow unpack',
    )
    const folder = await shop.makeFolder('named')
    expect(await pack(shop.json('named/wrinkles.json', {}))).toMatch(`; name its folder, ${folder}`)
  })

  it('is downloaded by the user', async () => {
    const failure = await shop.failure(inspectCommand, 'https://example.org/a.glb')
    expect(failure.message).toBe(
      'furrow inspect: cannot read the face https://example.org/a.glb (it is on the network); download it, and name the file',
    )
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

  it('is offered for meshes, materials, blendshapes and choices', async () => {
    const folder = await shop.makeFolder('near')
    const pack = (...args: string[]) => shop.failure(packCommand, folder, '-o', shop.path('x.glb'), ...args)
    expect((await pack('--mesh', 'skim')).message).toMatch(/; did you mean "skin"\?$/)
    expect((await pack('--mesh', 'eyes', '--material', 'eye')).message).toMatch(/; did you mean "eyes"\?$/)
    const activations = (...args: string[]) => shop.failure(activationsCommand, 'faces/human.glb', ...args)
    expect((await activations('--set', 'jawOpne=1')).message).toMatch(/; did you mean "jawOpen"\?$/)
    expect((await activations('--expression', 'hapy')).message).toMatch(/; did you mean "happy"\?$/)
    expect((await activations('--expresion', 'happy')).message).toMatch(/; did you mean "--expression"\?$/)
    expect((await shop.failure(packCommand, folder, '--outptu', 'x.glb')).message).toBe(
      `furrow pack: unknown option '--outptu'; did you mean "--output"?`,
    )
  })
})

describe('what is printed', () => {
  it('obeys nothing that a file says to a terminal', () => {
    expect(escaped('a\x1b[2Jb\x07\x9bc')).toBe('a\\u001b[2Jb\\u0007\\u009bc')
    expect(escaped('two\nlines\r')).toBe('two\\u000alines\\u000d')
    expect(escaped('\u202eevil\u2066\u200f')).toBe('\\u202eevil\\u2066\\u200f')
    expect(escaped('Ünï © 日本語 👩‍🚀')).toBe('Ünï © 日本語 👩‍🚀')
  })

  it('stays JSON, with the same values', () => {
    const value = { name: 'a\x1b\x9b\u202e\n' }
    expect(JSON.parse(escaped(JSON.stringify(value)))).toEqual(value)
  })

  it('goes to stderr where stdout takes a file', () => {
    const stderr = vi.spyOn(process.stderr, 'write').mockReturnValue(true)
    print('to stdout', 'x.png', undefined)
    print('to stderr', 'x.png', '-')
    expect(shop.printed).toBe('to stdout\n')
    expect(stderr.mock.calls).toEqual([['to stderr\n']])
    stderr.mockRestore()
  })

  it('is one line per line', () => {
    print(['one\ntwo', 'three'])
    warn('four\nfive')
    expect(shop.printed).toBe('one\\u000atwo\nthree\n')
    expect(shop.warned).toBe('four\\u000afive\n')
  })

  it('of a file whose names are hostile is harmless', async () => {
    const folder = await shop.makeFolder('hostile')
    shop.write(
      'hostile/face.glb',
      editGlb(await faceBytes(), (json) => {
        json.materials[0].name = 'skin\x1b[31m\nerror: all is lost'
      }),
    )
    await shop.run(packCommand, folder, '-o', shop.path('hostile.glb'), '--mesh', 'skin')
    await shop.run(inspectCommand, shop.path('hostile.glb'))
    expect(shop.printed).toContain('skin\\u001b[31m\\u000aerror: all is lost')
    expect(shop.printed).not.toContain('\x1b')
  })
})

it('a face without wrinkles is sent to furrow auto', async () => {
  const error = await shop.failure(activationsCommand, shop.write('plain.glb', await faceBytes()))
  expect(error.message).toMatch(/plain\.glb has no wrinkles, .*; make them with furrow auto/)
})
