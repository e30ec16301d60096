import { execFileSync } from 'node:child_process'
import {
  existsSync,
  linkSync,
  lstatSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  readlinkSync,
  symlinkSync,
} from 'node:fs'
import { encodeGlb } from 'furrow-files'
import { fileProblem, readDocument, readGlbFile } from 'furrow-files/node'
import { validateBytes } from 'gltf-validator'
import { beforeAll, describe, expect, it } from 'vitest'
import { writeAll, writeFolder } from '../../../packages/cli/src/files.ts'
import { checkOutputs, isStdout } from '../../../packages/cli/src/outputs.ts'
import type { CommandName } from '../../commands.ts'
import { noise } from '../../noise.ts'
import { painted, Workshop } from './workshop.ts'

const WHO = 'furrow test'
const STROKES = 'faces/human/drawn.json'
const FACE = 'faces/human.glb'

const shop = new Workshop()
const at = (name: string) => shop.path(name)

type Outputs = [name: CommandName, extension: string, args: (outputs: string[]) => string[]]

/** Every command that writes files, with a function that returns its arguments for one or two outputs. */
const COMMANDS: Outputs[] = [
  ['array', 'ktx2', ([o]) => [at('tile.png'), '-o', o]],
  ['auto', 'glb', ([o]) => [FACE, '-o', o, '--replace']],
  ['bake', 'png', ([o, p]) => [FACE, FACE, '-o', o, ...(p ? ['--height', p] : [])]],
  ['inspect', 'png', ([o]) => [FACE, '--sheet', o]],
  ['normals', 'png', ([o]) => [at('tile.png'), '-o', o, '--strength', '3']],
  ['pack', 'glb', ([o]) => [at('face'), '-o', o]],
  ['render', 'png', ([o]) => [FACE, '-o', o]],
  ['strokes', 'png', ([o, p]) => [STROKES, '--face', FACE, '-o', o, ...(p ? ['--normal', p] : [])]],
]

beforeAll(async () => {
  await shop.makeFolder('face')
  shop.write('tile.png', await painted(1, 16))
  for (const extension of ['glb', 'png', 'ktx2']) {
    mkdirSync(at(`folder.${extension}`))
    execFileSync('mkfifo', [at(`pipe.${extension}`)])
  }
})

describe.each(COMMANDS)('before any work furrow %s refuses', (name, extension, args) => {
  it.each([
    ['a pipe', `pipe.${extension}`, 'it is a device, pipe or socket); choose a file'],
    ['a folder', `folder.${extension}`, 'it is a folder'],
    ['a file below a file', `tile.png/x.${extension}`, 'is not a folder'],
    ['another ending', 'x.txt', `the name does not end in .${extension}`],
  ])('as output %s', async (_, path, problem) => {
    await shop.fails(`cannot write ${at(path)} (`, name, ...args([at(path)]))
    await shop.fails(problem, name, ...args([at(path)]))
    expect(lstatSync(at(`pipe.${extension}`)).isFIFO()).toBe(true)
  })
})

describe('an output', () => {
  it('may replace only a regular file', () => {
    const kind = (isFile: boolean, isDirectory: boolean) => ({
      isFile: () => isFile,
      isDirectory: () => isDirectory,
    })
    expect(fileProblem(undefined)).toBeUndefined()
    expect(fileProblem(kind(true, false))).toBeUndefined()
    expect(fileProblem(kind(false, true))).toBe('it is a folder')
    expect(fileProblem(kind(false, false))).toBe('it is a device, pipe or socket')
  })

  it('is written to the target of a symbolic link', async () => {
    shop.write('links/real.png', 'old')
    symlinkSync('real.png', at('links/one.png'))
    symlinkSync(at('links/one.png'), at('links/two.png'))
    symlinkSync('later/new.png', at('links/dangling.png'))
    await writeAll(
      ['two', 'dangling'].map((name) => ({ path: at(`links/${name}.png`), bytes: Buffer.from(name) })),
      WHO,
    )
    expect(readFileSync(at('links/real.png'), 'utf8')).toBe('two')
    expect(readlinkSync(at('links/two.png'))).toBe(at('links/one.png'))
    expect(readFileSync(at('links/later/new.png'), 'utf8')).toBe('dangling')
    expect(readdirSync(at('links'))).toEqual(['dangling.png', 'later', 'one.png', 'real.png', 'two.png'])
  })

  it('is refused if symbolic links form a circle', async () => {
    symlinkSync('b.png', at('a.png'))
    symlinkSync('a.png', at('b.png'))
    await expect(checkOutputs([at('a.png')], WHO)).rejects.toThrow(/its symbolic links form a cycle/)
  })

  it.each(COMMANDS.filter(([, , args]) => args(['a', 'b']).includes('b')))(
    'of furrow %s is refused before any work if it is also another output, by whatever name',
    async (command, _, args) => {
      shop.write('same/a.png', 'precious')
      if (!existsSync(at('same/b.png'))) linkSync(at('same/a.png'), at('same/b.png'))
      if (!existsSync(at('other'))) symlinkSync('same', at('other'))
      for (const name of ['same/a', 'same/../same/a', 'same/b', 'other/a', 'same/new', 'other/new']) {
        const first = name.endsWith('new') ? 'same/new' : 'same/a'
        const outputs = [first, name].map((output) => at(`${output}.png`))
        await shop.fails('two outputs are the same file', command, ...args(outputs))
      }
      expect(readFileSync(at('same/a.png'), 'utf8')).toBe('precious')
    },
  )

  it('of strokes must also differ from the area files', async () => {
    const args = [STROKES, '--face', FACE, '--areas', at('areas'), '-o', at('areas/nose.png')]
    await shop.fails('two outputs are the same file', 'strokes', ...args)
  })
})

describe('an input', () => {
  const precious = async (name: string) => {
    const bytes = name.endsWith('.png') ? await painted(1, 16) : readFileSync(at('face/face.glb'))
    return shop.write(name, bytes)
  }

  it.each<[CommandName, string, (path: string) => string[]]>([
    ['pack', 'in.glb', (path) => [at('face'), '--face', path, '-o', path]],
    ['auto', 'in.glb', (path) => [path, '-o', path]],
    ['normals', 'in.png', (path) => [path, '-o', path, '--strength', '1']],
    ['strokes', 'in.png', (path) => [STROKES, '--face', FACE, '--base', path, '--normal', path]],
  ])('is replaced by furrow %s only with --force', async (command, name, args) => {
    const path = await precious(name)
    const before = readFileSync(path)
    const message = / is the input; choose another output, or overwrite it with --force$/
    await shop.fails(message, command, ...args(path))
    expect(readFileSync(path)).toEqual(before)
    const forced = await shop.failure(command, ...args(path), '--force')
    expect(forced.message).not.toContain('is the input')
  })

  it('is recognised by any of its names, such as links', async () => {
    const path = await precious('named/in.png')
    linkSync(path, at('named/hard.png'))
    symlinkSync('in.png', at('named/soft.png'))
    for (const name of ['hard', 'soft', '../named/in']) {
      const args = [path, '-o', at(`named/${name}.png`), '--strength', '1']
      await shop.fails('is the input', 'normals', ...args)
    }
  })

  it('to which a .gltf refers is not replaced by a part of the output', async () => {
    await shop.run('pack', at('face'), '-o', at('split/a.gltf'))
    const json = readFileSync(at('split/a.gltf'), 'utf8')
    shop.write('split/b.gltf', json)
    const before = shop.files('split')
    const args = [at('face'), '--face', at('split/b.gltf'), '-o', at('split/a.gltf')]
    await shop.fails(/a-1\.png is the input; choose another output$/, 'pack', ...args)
    expect(shop.files('split')).toEqual(before)
    await shop.run('pack', ...args, '--force')
    for (const name of ['split/a.gltf', 'split/b.gltf']) expect(await validatorErrors(name)).toEqual([])
    const { 'a.gltf': _, ...shared } = before
    expect(shop.files('split')).toMatchObject(shared)
  })
})

async function validatorErrors(name: string): Promise<string[]> {
  const glb = await readGlbFile(at(name), WHO)
  const { issues } = await validateBytes(encodeGlb(glb), {})
  return issues.messages
    .filter(({ severity, message }) => severity === 0 && !message.includes('FURROW'))
    .map(({ message }) => message)
}

describe('a face', () => {
  it('is written in the format of the file name, with the same content', async () => {
    for (const name of ['out.glb', 'out.vrm', 'OUT.GLTF']) {
      await shop.run('pack', at('face'), '-o', at(`kinds/${name}`))
      expect(shop.printed).toContain(`${at(`kinds/${name}`)}: material "skin"`)
    }
    expect(readFileSync(at('kinds/out.vrm'))).toEqual(readFileSync(at('kinds/out.glb')))
    const numbers = async (name: string) =>
      (await readDocument(at(`kinds/${name}`), WHO))
        .getRoot()
        .listAccessors()
        .map((accessor) => [...accessor.getArray()!])
    expect(await numbers('OUT.GLTF')).toEqual(await numbers('out.glb'))
  })

  it('as .gltf has its buffer and images as separate files, without duplicates', async () => {
    await shop.run('pack', at('face'), '-o', at('gltf/my face.gltf'))
    const names = readdirSync(at('gltf'))
    const images = names.filter((name) => name.endsWith('.png'))
    expect(names).toEqual(['my face.bin', 'my face.gltf', ...images].sort())
    const json = JSON.parse(readFileSync(at('gltf/my face.gltf'), 'utf8'))
    expect(json.buffers).toEqual([
      { uri: 'my%20face.bin', byteLength: readFileSync(at('gltf/my face.bin')).length },
    ])
    expect(new Set(json.images.map(({ uri }: { uri: string }) => decodeURIComponent(uri)))).toEqual(
      new Set(images),
    )
    const used = json.accessors.map(({ bufferView }: { bufferView: number }) => bufferView)
    expect(json.bufferViews).toHaveLength(new Set(used).size)
    const bytes = readFileSync(at('gltf/my face.gltf'))
    const { issues } = await validateBytes(new Uint8Array(bytes), {
      externalResourceFunction: async (uri) =>
        new Uint8Array(readFileSync(at(`gltf/${decodeURIComponent(uri)}`))),
    })
    expect(issues.messages.filter(({ severity }) => severity === 0)).toEqual([])
  })
})

describe('stdout', () => {
  it.each(['-', '/dev/stdout', '/dev/fd/1', '/proc/self/fd/1'])('is %s', (path) => {
    expect(isStdout(path)).toBe(true)
  })

  it('can be used for only one output', async () => {
    await expect(checkOutputs(['-', '/dev/stdout'], WHO)).rejects.toThrow(/two outputs are the same file/)
  })
})

describe('files are written all or not at all', () => {
  it('if one of them cannot be written, and no folder stays behind', async () => {
    shop.write('whole/file', 'x')
    const files = ['whole/new/deep/a.png', 'whole/b.png', 'whole/file/c.png']
    const outputs = files.map((name) => ({ path: at(name), bytes: Buffer.from('a') }))
    await expect(writeAll(outputs, WHO)).rejects.toThrow(/cannot write .*c\.png \(the name already exists/)
    expect(readdirSync(at('whole'))).toEqual(['file'])
  })

  it('if a folder must be new and exists', async () => {
    shop.write('full/mine.txt', 'x')
    const outputs = [{ path: 'a/b.png', bytes: Buffer.from('a') }]
    await expect(writeFolder(at('full'), outputs, WHO)).rejects.toThrow(/cannot write/)
    const tooLong = [{ path: 'n'.repeat(300), bytes: Buffer.from('a') }]
    await expect(writeFolder(at('new'), tooLong, WHO)).rejects.toThrow(/cannot write .*new\/nnn.*too long/)
    expect(shop.files('full')).toEqual({ 'mine.txt': Buffer.from('x').toString('base64') })
  })

  it('also if their names have the maximum length', async () => {
    const name = `${'n'.repeat(251)}.png`
    await checkOutputs([at(name)], WHO)
    await writeAll([{ path: at(name), bytes: await noise(1) }], WHO)
    expect(existsSync(at(name))).toBe(true)
    await expect(checkOutputs([at(`n${name}`)], WHO)).rejects.toThrow(/the name is too long.*shorter name/)
  })
})
