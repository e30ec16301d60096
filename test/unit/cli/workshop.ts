import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { Document, NodeIO } from '@gltf-transform/core'
import sharp from 'sharp'
import { afterAll, beforeEach, expect, vi } from 'vitest'
import { accessorsOf } from '../../accessors.ts'
import { type CommandName, runCommand } from '../../commands.ts'
import { editGlb, jsonOf } from '../../glb.ts'
import { noise } from '../../noise.ts'

/** Temporary folder for the tests of a file, with functions that write files there and run commands. */
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

  readonly path = (name: string): string => join(this.root, name)

  write(name: string, content: string | Uint8Array): string {
    const path = this.path(name)
    mkdirSync(dirname(path), { recursive: true })
    writeFileSync(path, content)
    return path
  }

  json(name: string, value: unknown): string {
    return this.write(name, JSON.stringify(value))
  }

  /** Returns the bytes of every file below a folder, base64. The keys are relative paths. */
  files(folder = '.'): Record<string, string> {
    const names = readdirSync(this.path(folder), { recursive: true, withFileTypes: true })
    const paths = names.filter((item) => item.isFile()).map((item) => join(item.parentPath, item.name))
    return Object.fromEntries(
      paths.sort().map((path) => [path.slice(this.path(folder).length + 1), readFileSync(path, 'base64')]),
    )
  }

  /** Runs `furrow NAME` as a user would. */
  async run(name: CommandName, ...args: string[]): Promise<void> {
    await runCommand(name, ...args)
  }

  /** Runs a command and returns its output. */
  async output(name: CommandName, ...args: string[]): Promise<string> {
    this.printed = ''
    await this.run(name, ...args)
    return this.printed
  }

  /** Returns the error of a run that must fail. */
  async failure(name: CommandName, ...args: string[]): Promise<Error> {
    return this.run(name, ...args).then(
      () => new Error('it did not fail'),
      (error) => error,
    )
  }

  /** Runs a command. Expects an error of one line that contains or matches `message`, and that no file was added or removed. */
  async fails(message: string | RegExp, name: CommandName, ...args: string[]): Promise<void> {
    const list = () => readdirSync(this.root, { recursive: true }).sort()
    const before = list()
    const failure = await this.failure(name, ...args)
    expect(failure.message).toMatch(message)
    expect(failure.name).toBe('FurrowError')
    expect(failure.message).toMatch(new RegExp(`^furrow ${name}: [^\\n]*; [^\\n]*$`))
    expect(list()).toEqual(before)
  }

  /** Makes a folder as users do: a face, two layers and five areas. The names of the areas are in alphabetical order. */
  async makeFolder(name: string): Promise<string> {
    this.write(`${name}/face.glb`, await faceBytes())
    this.write(`${name}/layers/age/normal.png`, await noise(1))
    this.write(`${name}/layers/expression/normal.png`, await noise(2))
    this.write(`${name}/layers/expression/baseColor.png`, await noise(3))
    for (const [i, area] of AREAS.entries()) this.write(`${name}/areas/${area}.png`, await painted(i))
    return this.path(name)
  }
}

/** Creates a workshop for the tests of one command. */
export function bench(command: CommandName) {
  const shop = new Workshop()
  return {
    shop,
    folder: shop.root,
    file: shop.path,
    get printed() {
      return shop.printed
    },
    get warned() {
      return shop.warned
    },
    run: (...args: string[]) => shop.run(command, ...args),
    output: (...args: string[]) => shop.output(command, ...args),
    fails: (message: string | RegExp, ...args: string[]) => shop.fails(message, command, ...args),
  }
}

export const AREAS = ['brow', 'cheek', 'chin', 'eye', 'nose']

/** Makes the image of an area: dark, which means visible, in one of eight columns, and white elsewhere. */
export function painted(column: number, size = 128): Promise<Uint8Array> {
  const data = Uint8Array.from({ length: size * size }, (_, i) => {
    return Math.floor((8 * (i % size)) / size) === column ? (i >> 7) % 120 : 255
  })
  return grayPng(data, size)
}

/** Makes a square gray PNG file of 8 or 16 bits. */
export function grayPng(data: Uint8Array | Uint16Array, size: number): Promise<Uint8Array> {
  return sharp(data, { raw: { width: size, height: size, channels: 1 } })
    .toColourspace(data instanceof Uint16Array ? 'grey16' : 'b-w')
    .png()
    .toBuffer()
}

/** Returns the texels of a gray image. */
export async function grayOf(path: string): Promise<number[]> {
  return [...(await sharp(path).toColourspace('b-w').raw().toBuffer())]
}

/** Returns the extension of a material in a file. */
export function wrinklesIn(path: string, material = 0) {
  return jsonOf(readFileSync(path)).materials[material].extensions.FURROW_wrinkle_maps
}

/** Makes a file with a mesh per name, by default `skin` and `eyes`. Each is a triangle with a normal map and the blendshape `browInnerUp`. */
export async function faceBytes(names = ['skin', 'eyes']): Promise<Uint8Array> {
  const document = new Document()
  const accessor = accessorsOf(document)
  const vectors = (type: 'VEC2' | 'VEC3' | 'VEC4', ...values: number[]) =>
    accessor(type, Float32Array.from(values))
  const texture = async (seed: number) =>
    document
      .createTexture(`skin ${seed}`)
      .setImage((await noise(seed)) as Uint8Array<ArrayBuffer>)
      .setMimeType('image/png')
  const scene = document.createScene()
  for (const name of names) {
    const material = document.createMaterial(name)
    material.setNormalTexture(await texture(8)).setBaseColorTexture(await texture(9))
    const target = document
      .createPrimitiveTarget('browInnerUp')
      .setAttribute('POSITION', vectors('VEC3', 0, 0, 1, 0, 0, 0, 0, 0, 0))
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', vectors('VEC3', 0, 0, 0, 1, 0, 0, 0, 1, 0))
      .setAttribute('NORMAL', vectors('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1))
      .setAttribute('TANGENT', vectors('VEC4', 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1))
      .setAttribute('TEXCOORD_0', vectors('VEC2', 0, 1, 1, 1, 0, 0))
      .setMaterial(material)
      .addTarget(target)
    const mesh = document
      .createMesh(name)
      .addPrimitive(primitive)
      .setExtras({ targetNames: ['browInnerUp'] })
    scene.addChild(document.createNode(name).setMesh(mesh))
  }
  return new NodeIO().writeBinary(document)
}

/** Makes a face of two meshes, `teeth` and `head`. Only the head has a blendshape. */
export async function stillTeeth(): Promise<Uint8Array> {
  return editGlb(await faceBytes(['teeth', 'head']), ({ meshes }) => delete meshes[0].primitives[0].targets)
}
