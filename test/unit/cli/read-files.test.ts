import { execFileSync } from 'node:child_process'
import { readFileSync, symlinkSync } from 'node:fs'
import { pathToFileURL } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import { encodeGlb, type GltfJson } from 'furrow-files'
import { readDocument, readGlbFile } from 'furrow-files/node'
import { validateBytes } from 'gltf-validator'
import { beforeAll, describe, expect, it } from 'vitest'
import type { CommandName } from '../../commands.ts'
import { editGlb } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { ONE_LINE } from '../../strokes.ts'
import { faceBytes, Workshop } from './workshop.ts'

const shop = new Workshop()
const WHO = 'furrow test'

/** Splits a file into its JSON and the buffer and images that it refers to. */
async function apart(bytes: Uint8Array) {
  const document = await new NodeIO().readBinary(bytes)
  for (const [i, texture] of document.getRoot().listTextures().entries()) texture.setURI(`skin ${i}.png`)
  const { json, resources } = await new NodeIO().writeJSON(document, { basename: 'face' })
  return { json: json as GltfJson, resources }
}

/** Writes `NAME/face.gltf` and its separate files. Returns its path. */
async function writeApart(name: string, edit: (json: GltfJson) => void = () => {}): Promise<string> {
  const { json, resources } = await apart(await faceBytes())
  for (const [file, bytes] of Object.entries(resources)) shop.write(`${name}/${file}`, bytes)
  edit(json)
  return shop.json(`${name}/face.gltf`, json)
}

/** Returns every number of every accessor. */
async function numbersOf(path: string): Promise<number[][]> {
  const document = await readDocument(path, WHO)
  return document
    .getRoot()
    .listAccessors()
    .map((accessor) => [...accessor.getArray()!])
}

async function validatorErrors(bytes: Uint8Array): Promise<string[]> {
  const { issues } = await validateBytes(bytes, {})
  return issues.messages.filter(({ severity }) => severity === 0).map(({ message }) => message)
}

describe('a file with separate parts', () => {
  it('is read like the same file in one piece', async () => {
    const whole = shop.write('whole.glb', await faceBytes())
    const path = await writeApart('parts')
    expect(await numbersOf(path)).toEqual(await numbersOf(whole))
    const glb = await readGlbFile(path, WHO)
    expect(glb.json.images!.map(({ name, mimeType, uri }) => [name, mimeType, uri])).toEqual(
      [0, 1, 2, 3].map((i) => [`skin ${i % 2 === 0 ? 8 : 9}`, 'image/png', undefined]),
    )
    expect(await validatorErrors(encodeGlb(glb))).toEqual([])
  })

  it('keeps unknown extensions and fields', async () => {
    const path = await writeApart('unknown', (json) => {
      json.extensionsUsed = ['ACME_moods']
      json.extensions = { ACME_moods: { moods: ['sour'] } }
      Object.assign(json.meshes![0], { acme: 1 })
    })
    const { json } = await readGlbFile(path, WHO)
    expect(json).toMatchObject({
      extensionsUsed: ['ACME_moods'],
      extensions: { ACME_moods: { moods: ['sour'] } },
      meshes: [{ acme: 1 }, {}],
    })
  })

  it.each([
    ['face.vrm', 'binary'],
    ['face.bin', 'binary'],
    ['face.json', 'text'],
  ])('is recognised by its content: %s', async (name, kind) => {
    const bytes = await faceBytes()
    const data = kind === 'binary' ? bytes : Buffer.from(JSON.stringify({ asset: { version: '2.0' } }))
    expect((await readGlbFile(shop.write(`kinds/${name}`, data), WHO)).fileBytes).toBe(data.length)
  })

  it('may store its parts as data URIs', async () => {
    const { json, resources } = await apart(await faceBytes())
    for (const item of [...json.buffers!, ...json.images!]) {
      item.uri = `data:application/octet-stream;base64,${Buffer.from(resources[item.uri!]).toString('base64')}`
    }
    const glb = await readGlbFile(shop.json('data/face.gltf', json), WHO)
    expect(await validatorErrors(encodeGlb(glb))).toEqual([])
  })

  it.each(['skin%200.png', './skin 0.png', 'folder\\..\\skin%200.png'])(
    'is validated with them by the Khronos validator, by any path: %s',
    async (uri) => {
      const path = await writeApart('validated', (json) => {
        json.images![0] = { uri }
      })
      await shop.run('validate', path)
      expect(shop.printed).toMatch(/: 0 errors, 1 warning$/m)
    },
  )

  it('stores a file only once if it refers to it several times', async () => {
    const path = await writeApart('twice')
    const once = (await readGlbFile(path, WHO)).bin.length
    const again = await writeApart('twice', (json) => {
      json.buffers!.push(...Array.from({ length: 50 }, () => json.buffers![0]))
      json.images!.push(...Array.from({ length: 50 }, () => ({ ...json.images![0] })))
    })
    expect((await readGlbFile(again, WHO)).bin.length).toBe(once)
  })

  it('keeps buffers without data that are fallbacks of compressed meshes', async () => {
    const path = await writeApart('fallback', (json) => {
      const [view] = json.bufferViews!
      const fallback = json.buffers!.unshift({ byteLength: view.byteLength }) && 0
      for (const item of json.bufferViews!) item.buffer = 1
      const compressed = { ...view, count: view.byteLength / 4, byteStride: 4, mode: 'ATTRIBUTES' }
      view.extensions = { EXT_meshopt_compression: compressed }
      Object.assign(view, { buffer: fallback, byteOffset: 0 })
    })
    const { json } = await readGlbFile(path, WHO)
    expect(json.buffers).toHaveLength(2)
    expect(json.bufferViews![0]).toMatchObject({
      buffer: 1,
      extensions: { EXT_meshopt_compression: { buffer: 0 } },
    })
    expect(json.bufferViews![1].buffer).toBe(0)
  })

  it.each<[string, (json: GltfJson) => void, RegExp]>([
    [
      'a buffer is cut off',
      ({ buffers }) => (buffers![0].byteLength += 5000),
      /buffers\[0\] has \d+ of \d+ bytes, got "face.bin"/,
    ],
    [
      'a view reaches beyond its buffer',
      ({ bufferViews }) => (bufferViews![0].byteLength += 5000),
      /bufferViews\[0\] is not within its buffer/,
    ],
    [
      'a view has no buffer',
      ({ bufferViews }) => (bufferViews![1].buffer = 7),
      /bufferViews\[1\] is not within its buffer/,
    ],
  ])('is refused when %s', async (name, edit, message) => {
    await expect(readGlbFile(await writeApart(name, edit), WHO)).rejects.toThrow(message)
  })

  it('is refused when an image has an unknown format', async () => {
    const path = await writeApart('text', (json) => {
      json.images![0] = { uri: 'face.bin' }
    })
    await expect(readGlbFile(path, WHO)).rejects.toThrow(
      /unknown format, got "face\.bin", .*; convert it to PNG/,
    )
  })
})

describe('a binary file whose first buffer is another file', () => {
  beforeAll(async () => {
    await shop.makeFolder('external')
    const bytes = await faceBytes()
    const glb = await readGlbFile(shop.path('external/face.glb'), WHO)
    shop.write('external/face.bin', glb.bin)
    const whole = editGlb(bytes, (json) => {
      json.buffers[0].uri = 'face.bin'
    })
    shop.write('external/face.glb', whole.subarray(0, 20 + new DataView(whole.buffer).getUint32(12, true)))
    const cut = Buffer.from(readFileSync(shop.path('external/face.glb')))
    cut.writeUInt32LE(cut.length, 8)
    shop.write('external/face.glb', cut)
  })

  it('becomes one valid file', async () => {
    await shop.run('pack', shop.path('external'), '-o', shop.path('external.glb'))
    expect(await validatorErrors(readFileSync(shop.path('external.glb')))).toEqual([])
  })
})

describe('files outside the folder', () => {
  const hostile: [string, string][] = [
    ['the folder above', '../secret.png'],
    ['an escaped path', '%2e%2e%2fsecret.png'],
    ['backslashes', '..\\secret.png'],
    ['escaped backslashes', '..%5Csecret.png'],
    ['a way round', 'folder/../../secret.png'],
    ['an absolute path', 'ABSOLUTE'],
    ['the scheme file:', 'FILE'],
    ['a link', 'link.png'],
    ['a linked folder', 'up/secret.png'],
  ]
  let secret = ''
  beforeAll(async () => {
    secret = shop.write('outside/secret.png', await noise(5))
    await writeApart('outside/in')
    symlinkSync(secret, shop.path('outside/in/link.png'))
    symlinkSync('..', shop.path('outside/in/up'))
    symlinkSync('skin 0.png', shop.path('outside/in/near.png'))
    execFileSync('mkfifo', [shop.path('outside/in/pipe.png')])
  })

  const withImage = (uri: string) =>
    writeApart('outside/in', (json) => {
      const address = uri.replace('ABSOLUTE', secret).replace('FILE', pathToFileURL(secret).href)
      json.images![0] = { uri: address }
    })

  it.each(hostile)('are not read: %s', async (_, uri) => {
    const path = await withImage(uri)
    await expect(readGlbFile(path, WHO)).rejects.toThrow(/outside its folder, got .*--allow-outside$/)
    const { bin } = await readGlbFile(path, WHO, { allowOutside: true })
    expect(Buffer.from(bin).includes(readFileSync(secret))).toBe(true)
  })

  it('give the same error whether or not they exist', async () => {
    await expect(readGlbFile(await withImage('../nothing.png'), WHO)).rejects.toThrow(/outside its folder/)
  })

  it.each(['http://127.0.0.1/a.png', 'HTTPS://example.org/a.png', 'ftp:a.png', 'C:\\a.png'])(
    'are never read from %s',
    async (uri) => {
      const path = await withImage(uri)
      for (const allowOutside of [false, true]) {
        await expect(readGlbFile(path, WHO, { allowOutside })).rejects.toThrow(/references a remote file/)
      }
    },
  )

  it.each([
    ['pipe.png', /it is not a file/],
    ['.', /it is not a file/],
    ['none.png', /none\.png, referenced by .*face\.gltf.*; add the file/],
    ['a%00b', /face\.gltf has a URI with a NUL character, got "a%00b", .*; correct the URI$/],
    ['a\0b', /a URI with a NUL character/],
    ['', /face\.gltf has an empty URI, got ""/],
    ['data:image/png;base64', /without a comma before its data/],
  ])('are not read if they are no regular files: %s', async (uri, message) => {
    await expect(readGlbFile(await withImage(uri), WHO)).rejects.toThrow(message)
  })

  it.each(['near.png', './skin%200.png', 'up/in/skin 0.png', 'folder\\..\\skin 0.png'])(
    'are not read through a path inside the folder: %s',
    async (uri) => {
      await expect(readGlbFile(await withImage(uri), WHO)).resolves.toBeDefined()
    },
  )

  it.each<[CommandName, (face: string) => string[]]>([
    ['activations', (face) => [face]],
    ['auto', (face) => [face, '-o', shop.path('x.glb')]],
    ['bake', (face) => [face, face, '-o', shop.path('x.png'), '--size', '16']],
    ['inspect', (face) => [face]],
    ['pack', (face) => [shop.path('external'), '--face', face, '-o', shop.path('x.glb')]],
    ['strokes', (face) => [shop.json('lines.json', ONE_LINE), '--face', face, '-o', shop.path('x.png')]],
    ['unpack', (face) => [face, '-o', shop.path('x')]],
  ])('are read by furrow %s only if the user allows it', async (name, args) => {
    const face = await withImage('../secret.png')
    await shop.fails(`${face} references a file outside its folder`, name, ...args(face))
    const allowed = await shop.failure(name, ...args(face), '--allow-outside')
    expect(allowed.message).not.toContain('outside its folder')
  })
})
