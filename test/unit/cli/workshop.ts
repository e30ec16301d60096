import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { Document, NodeIO } from '@gltf-transform/core'
import type { Command } from 'commander'
import sharp from 'sharp'
import { afterAll, beforeEach, vi } from 'vitest'

/** A temporary folder with a face and the images of a wrinkle set, and what commands print. */
export class Workshop {
  readonly root = mkdtempSync(join(tmpdir(), 'furrow-cli-'))
  printed = ''
  warned = ''

  constructor() {
    beforeEach(() => {
      this.printed = ''
      this.warned = ''
      process.exitCode = undefined
      vi.spyOn(process.stdout, 'write').mockImplementation((text) => {
        this.printed += text
        return true
      })
      vi.spyOn(console, 'error').mockImplementation((text) => {
        this.warned += `${text}\n`
      })
    })
    afterAll(() => {
      vi.restoreAllMocks()
      process.exitCode = undefined
      rmSync(this.root, { recursive: true })
    })
  }

  path(name: string): string {
    return join(this.root, name)
  }

  write(name: string, content: string | Uint8Array): string {
    const path = this.path(name)
    mkdirSync(dirname(path), { recursive: true })
    writeFileSync(path, content)
    return path
  }

  json(name: string, value: unknown): string {
    return this.write(name, JSON.stringify(value))
  }

  /** Every file below a folder, with its bytes. */
  files(folder = '.'): Record<string, string> {
    const names = readdirSync(this.path(folder), { recursive: true, withFileTypes: true })
    const paths = names.filter((item) => item.isFile()).map((item) => join(item.parentPath, item.name))
    return Object.fromEntries(
      paths.sort().map((path) => [path.slice(this.path(folder).length + 1), readFileSync(path, 'base64')]),
    )
  }

  run(command: Command, ...args: string[]): Promise<Command> {
    return command.parseAsync(args, { from: 'user' })
  }

  /** The error of a run that must fail. */
  async failure(command: Command, ...args: string[]): Promise<Error> {
    return this.run(command, ...args).then(
      () => new Error('it did not fail'),
      (error) => error,
    )
  }

  /** A folder as a person makes it: a face, two layers, five areas; their order in the alphabet is their order. */
  async makeFolder(name: string): Promise<string> {
    this.write(`${name}/face.glb`, await faceBytes())
    this.write(`${name}/layers/age/normal.png`, await noise(1, 3))
    this.write(`${name}/layers/expression/normal.png`, await noise(2, 3))
    this.write(`${name}/layers/expression/baseColor.png`, await noise(3, 3))
    for (const [i, area] of AREAS.entries()) this.write(`${name}/areas/${area}.png`, await painted(i))
    return this.path(name)
  }
}

export const AREAS = ['brow', 'cheek', 'chin', 'eye', 'nose']

/** An area in the paper's convention: black in a column of its own, white elsewhere. */
export function painted(column: number, size = 128): Promise<Uint8Array> {
  const data = Uint8Array.from({ length: size * size }, (_, i) => {
    return Math.floor((8 * (i % size)) / size) === column ? (i >> 7) % 120 : 255
  })
  return sharp(data, { raw: { width: size, height: size, channels: 1 } })
    .toColourspace('b-w')
    .png()
    .toBuffer()
}

export function noise(seed: number, channels: 3 | 4, size = 16): Promise<Uint8Array> {
  const data = Uint8Array.from({ length: channels * size * size }, (_, i) => (i * 37 + seed * 101) % 251)
  return sharp(data, { raw: { width: size, height: size, channels } })
    .png()
    .toBuffer()
}

/** A quad named `skin` with a normal map and the blendshape `browInnerUp`, and a second mesh beside it. */
export async function faceBytes(names = ['skin', 'eyes']): Promise<Uint8Array> {
  const document = new Document()
  const buffer = document.createBuffer()
  const accessor = (type: 'VEC2' | 'VEC3' | 'VEC4', values: number[]) =>
    document.createAccessor().setType(type).setArray(Float32Array.from(values)).setBuffer(buffer)
  const texture = async (seed: number) =>
    document
      .createTexture(`skin ${seed}`)
      .setImage((await noise(seed, 3)) as Uint8Array<ArrayBuffer>)
      .setMimeType('image/png')
  const scene = document.createScene()
  for (const name of names) {
    const material = document.createMaterial(name)
    material.setNormalTexture(await texture(8)).setBaseColorTexture(await texture(9))
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', [0, 0, 0, 1, 0, 0, 0, 1, 0]))
      .setAttribute('NORMAL', accessor('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 1]))
      .setAttribute('TANGENT', accessor('VEC4', [1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1]))
      .setAttribute('TEXCOORD_0', accessor('VEC2', [0, 1, 1, 1, 0, 0]))
      .setMaterial(material)
    const target = document.createPrimitiveTarget('browInnerUp')
    primitive.addTarget(target.setAttribute('POSITION', accessor('VEC3', [0, 0, 1, 0, 0, 0, 0, 0, 0])))
    const mesh = document
      .createMesh(name)
      .addPrimitive(primitive)
      .setExtras({ targetNames: ['browInnerUp'] })
    scene.addChild(document.createNode(name).setMesh(mesh))
  }
  return new NodeIO().writeBinary(document)
}

/** Takes a `.glb` apart: its JSON and where its binary part begins. */
export function jsonOf(bytes: Uint8Array) {
  const view = Buffer.from(bytes)
  return JSON.parse(view.toString('utf8', 20, 20 + view.readUInt32LE(12)))
}

/** The same file with another JSON. */
export function withJson(bytes: Uint8Array, json: unknown): Uint8Array {
  const view = Buffer.from(bytes)
  const rest = view.subarray(20 + view.readUInt32LE(12))
  const text = Buffer.from(JSON.stringify(json))
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 0x20)])
  const head = Buffer.from(view.subarray(0, 20))
  head.writeUInt32LE(20 + padded.length + rest.length, 8)
  head.writeUInt32LE(padded.length, 12)
  return Buffer.concat([head, padded, rest])
}
